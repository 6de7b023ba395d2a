// The estimator's seat: one interface for every estimator, the one in use chosen by a parameter.
#pragma once

#include "rsi/estimation/robust_least_squares.hpp"

namespace rsi {

// A further estimator is a further member and a further case; what goes in and what comes out stays the same.
class RollCentreEstimator {
 public:
    void init(const Parameters& parameters);
    void reset();

    // `fixed` must have been evaluated at the same measurement.
    RollCentreEstimate update(const RollPlaneModel& model, const Measurement& measured,
                              const FixedModelRoll& fixed);

 private:
    rsi_estimator in_use_{RSI_ESTIMATOR_PUBLISHED};
    RobustLeastSquares published_{};
};

}  // namespace rsi
