#include "rsi/estimation/roll_centre_estimator.hpp"

namespace rsi {

void RollCentreEstimator::tune(const Parameters& parameters) {
    in_use_ = static_cast<rsi_estimator>(parameters.estimator);
    published_.tune(parameters);
    consider_kalman_.tune(parameters);
}

void RollCentreEstimator::reset() {
    published_.reset();
    consider_kalman_.reset();
}

RollCentreEstimate RollCentreEstimator::update(const RollPlaneModel& model, const Measurement& measured,
                                               const FixedModelRoll& fixed, float extended_rsi,
                                               float speed_mps) {
    if (in_use_ == RSI_ESTIMATOR_PUBLISHED) {
        published_.update(regress(model, measured, fixed));
        return published_.estimate();
    }
    return consider_kalman_.update(measured, extended_rsi, speed_mps);
}

float RollCentreEstimator::movement_for_observer_m() const {
    return (in_use_ == RSI_ESTIMATOR_CONSIDER_KALMAN) ? consider_kalman_.movement_m() : 0.0F;
}

}  // namespace rsi
