#include "rsi/estimation/roll_centre_estimator.hpp"

namespace rsi {

void RollCentreEstimator::init(const Parameters& parameters) {
    published_.init(parameters);
}

void RollCentreEstimator::reset() {
    published_.reset();
}

RollCentreEstimate RollCentreEstimator::update(const RollPlaneModel& model, const Measurement& measured,
                                               const FixedModelRoll& fixed) {
    published_.update(regress(model, measured, fixed));
    return published_.estimate();
}

}  // namespace rsi
