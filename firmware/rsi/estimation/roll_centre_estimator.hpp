// Selects the estimator in use, which a parameter chooses; one interface for every estimator.
#pragma once

#include "rsi/estimation/consider_kalman.hpp"
#include "rsi/estimation/robust_least_squares.hpp"

namespace rsi {

// A further estimator is a further member and a further case; what goes in and what comes out stays the same.
class RollCentreEstimator {
 public:
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters)
            : in_use(static_cast<rsi_estimator>(parameters.estimator)),
              published(parameters),
              consider_kalman(parameters) {}

        rsi_estimator in_use{RSI_ESTIMATOR_PUBLISHED};
        RobustLeastSquares::Constants published;
        ConsiderKalman::Constants consider_kalman;
    };

    // Forgets everything.
    [[gnu::cold, gnu::noinline]] void reset(const Constants& constants);

    // For other units of the published estimator, in which stands what it has learnt.
    void reset_published() { published_.reset(); }

    // For a gap in the measurements: what has been learnt stays.
    void reset_signals() { consider_kalman_.reset_signals(); }

    // One sample. `fixed` must have been updated with the same measurement; `extended_rsi` is that of the
    // cycle before; NaN where a number is not available.
    RollCentreEstimate update(const Constants& constants, const Vehicle& vehicle, const Measurement& measured,
                              const FixedModelRoll& fixed, float extended_rsi, float speed_mps);

    // dh that the roll and bank observer may assume. Zero for the published estimator, whose estimate drifts
    // to where it fits anything.
    float movement_for_observer_m(const Constants& constants) const;

 private:
    RobustLeastSquares published_{};
    ConsiderKalman consider_kalman_{};
};

}  // namespace rsi
