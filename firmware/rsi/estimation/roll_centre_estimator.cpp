#include "rsi/estimation/roll_centre_estimator.hpp"

namespace rsi {

void RollCentreEstimator::init(const Parameters& parameters) {
    in_use_ = static_cast<rsi_estimator>(parameters.estimator);
    published_.init(parameters);
    consider_kalman_.init(parameters);
}

void RollCentreEstimator::reset() {
    published_.reset();
    consider_kalman_.reset();
    estimate_ = RollCentreEstimate{};
}

bool RollCentreEstimator::update(const RollPlaneModel& model, const Measurement& measured,
                                 const FixedModelRoll& fixed, float extended_rsi, float speed_mps,
                                 bool odd_sample) {
    if (in_use_ == RSI_ESTIMATOR_PUBLISHED) {
        published_.update(regress(model, measured, fixed));
        estimate_ = published_.estimate();
        return false;
    }
    if (odd_sample) {
        return false;
    }
    estimate_ = consider_kalman_.update(measured, extended_rsi, speed_mps);
    return true;
}

}  // namespace rsi
