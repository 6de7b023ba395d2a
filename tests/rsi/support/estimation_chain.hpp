// The component's way from sensors to the regression, out of its own parts: measurement, fixed-roll-centre
// model, regression.
#pragma once

#include "rsi/estimation/regression.hpp"
#include "rsi/estimation/roll_plane_model.hpp"
#include "rsi/measurement/measurement.hpp"
#include "tests/rsi/support/stages.hpp"

namespace rsi_test {

class EstimationChain {
 public:
    explicit EstimationChain(const rsi_parameters& parameters) : vehicle_{parameters} {
        stage_.init(parameters);
        fixed_.reset(0.0F);
    }

    // False when the inputs give no measurement.
    bool step(const rsi_inputs& inputs, rsi::Regression& regression) {
        if (!stage_.update(inputs, measurement_)) {
            return false;
        }
        fixed_.update(vehicle_, measurement_);
        regression = rsi::regress(vehicle_, measurement_, fixed_);
        return true;
    }

 private:
    MeasurementStage stage_{};
    rsi::Vehicle vehicle_;
    rsi::FixedModelRoll fixed_{};
    rsi::Measurement measurement_{};
};

}  // namespace rsi_test
