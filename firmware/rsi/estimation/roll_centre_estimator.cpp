#include "rsi/estimation/roll_centre_estimator.hpp"

namespace rsi {

void RollCentreEstimator::reset(const Constants& constants) {
    published_.reset();
    consider_kalman_.reset(constants.consider_kalman);
}

RollCentreEstimate RollCentreEstimator::update(const Constants& constants, const Vehicle& vehicle,
                                               const Measurement& measured, const FixedModelRoll& fixed,
                                               float extended_rsi, float speed_mps) {
    if (constants.in_use == RSI_ESTIMATOR_PUBLISHED) {
        published_.update(constants.published, regress(vehicle, measured, fixed));
        return published_.estimate(constants.published);
    }
    return consider_kalman_.update(constants.consider_kalman, vehicle, measured, extended_rsi, speed_mps);
}

float RollCentreEstimator::movement_for_observer_m(const Constants& constants) const {
    return (constants.in_use == RSI_ESTIMATOR_CONSIDER_KALMAN) ? consider_kalman_.movement_m() : 0.0F;
}

}  // namespace rsi
