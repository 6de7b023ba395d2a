#include "rsi/estimation/roll_centre_estimator.hpp"

namespace rsi {

void RollCentreEstimator::init(const Parameters& parameters) {
    in_use_ = static_cast<rsi_estimator>(parameters.estimator);
    published_.init(parameters);
    consider_kalman_.init(parameters);
}

void RollCentreEstimator::forget() {
    published_.reset();
    consider_kalman_.reset();
    estimate_ = RollCentreEstimate{};
    is_new_ = true;
}

bool RollCentreEstimator::update(const RollPlaneModel& model, const Measurement& measured,
                                 const FixedModelRoll& fixed, float extended_rsi, float speed_mps,
                                 bool odd_sample) {
    if (in_use_ == RSI_ESTIMATOR_PUBLISHED) {
        is_new_ = false;
        published_.update(regress(model, measured, fixed));
        estimate_ = published_.estimate();
        return false;
    }
    if (odd_sample) {
        return false;
    }
    is_new_ = false;
    estimate_ = consider_kalman_.update(measured, extended_rsi, speed_mps);
    return true;
}

}  // namespace rsi
