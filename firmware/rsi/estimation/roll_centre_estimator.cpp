#include "rsi/estimation/roll_centre_estimator.hpp"

namespace rsi {

void RollCentreEstimator::init(const Parameters& parameters) {
    in_use_ = static_cast<rsi_estimator>(parameters.estimator);
    published_.init(parameters);
}

void RollCentreEstimator::reset() {
    published_.reset();
}

RollCentreEstimate RollCentreEstimator::update(const RollPlaneModel& model, const Measurement& measured,
                                               const FixedModelRoll& fixed) {
    switch (in_use_) {
        case RSI_ESTIMATOR_CONSIDER_KALMAN:
            break;
        case RSI_ESTIMATOR_PUBLISHED:
            published_.update(regress(model, measured, fixed));
            return published_.estimate();
    }
    return RollCentreEstimate{};
}

}  // namespace rsi
