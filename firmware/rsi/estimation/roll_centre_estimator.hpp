// Selects the estimator in use, which a parameter chooses; one interface for every estimator.
#pragma once

#include "rsi/estimation/consider_kalman.hpp"
#include "rsi/estimation/robust_least_squares.hpp"

namespace rsi {

// A further estimator is a further member and a further case; what goes in and what comes out stays the same.
class RollCentreEstimator {
 public:
    [[gnu::cold]] void init(const Parameters& parameters) {
        tune(parameters);
        reset();
    }

    // The parameters from now on; what has been learnt stays.
    [[gnu::cold]] void tune(const Parameters& parameters);

    // What the published estimator has learnt stands in the units of its parameters.
    void forget_published() { published_.reset(); }

    // Forgets everything.
    [[gnu::cold, gnu::noinline]] void reset();

    // For a gap in the measurements: what has been learnt stays.
    void restart() { consider_kalman_.restart(); }

    // The body from now on. The published estimator takes it from the model.
    void assume_body(const SprungBody& body) { consider_kalman_.assume_body(body); }

    // One sample. `fixed` must have been updated with the same measurement; `extended_rsi` is that of the
    // cycle before; NaN where a number is not available.
    RollCentreEstimate update(const RollPlaneModel& model, const Measurement& measured,
                              const FixedModelRoll& fixed, float extended_rsi, float speed_mps);

    // dh that the roll and bank observer may assume. Zero for the published estimator, whose estimate drifts
    // to where it fits anything.
    float movement_for_observer_m() const;

 private:
    rsi_estimator in_use_{RSI_ESTIMATOR_PUBLISHED};
    RobustLeastSquares published_{};
    ConsiderKalman consider_kalman_{};
};

}  // namespace rsi
