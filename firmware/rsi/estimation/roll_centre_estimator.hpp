// The estimator's seat: one interface for every estimator, the one in use chosen by a parameter.
#pragma once

#include "rsi/estimation/consider_kalman.hpp"
#include "rsi/estimation/robust_least_squares.hpp"

namespace rsi {

// A further estimator is a further member and a further case; what goes in and what comes out stays the same.
class RollCentreEstimator {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);
    // Forgets everything.
    [[gnu::cold, gnu::noinline]] void reset();

    // For a gap in the measurements: what has been learnt stays.
    void restart() { consider_kalman_.restart(); }

    // `fixed` must have been evaluated at the same measurement; `extended_rsi` is that of the cycle before;
    // NaN where a number is not available. The published estimator runs in every sample, the consider-Kalman
    // filter in the even ones; its estimate holds in between. True where the estimate may move the observer
    // and has changed: the published one drifts to where it fits anything.
    bool update(const RollPlaneModel& model, const Measurement& measured, const FixedModelRoll& fixed,
                float extended_rsi, float speed_mps, bool odd_sample);

    // The last one.
    const RollCentreEstimate& estimate() const { return estimate_; }

 private:
    rsi_estimator in_use_{RSI_ESTIMATOR_PUBLISHED};
    RobustLeastSquares published_{};
    ConsiderKalman consider_kalman_{};
    RollCentreEstimate estimate_{};
};

}  // namespace rsi
