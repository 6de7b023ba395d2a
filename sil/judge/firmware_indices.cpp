#include "sil/judge/firmware_indices.hpp"

namespace sil {

float roll_angle_in_use(const rsi::Inputs& inputs, const rsi::Outputs& outputs) {
    return outputs.roll_source == RSI_ROLL_SENSOR ? inputs.roll_angle_rad : outputs.observed_roll_angle_rad;
}

FirmwareIndices::FirmwareIndices(const rsi::Parameters& calibration) {
    rsi::Parameters parameters = calibration;
    parameters.warning_indicator = 0;
    for (rsi::WarningIndicator& indicator : indicators_) {
        indicator = rsi::WarningIndicator{parameters};
        ++parameters.warning_indicator;
    }
}

rsi::RiskLevel FirmwareIndices::risk(std::size_t index, const rsi::Outputs& outputs,
                                     float roll_angle_rad) const {
    const rsi::IndicatedRisk risk = indicators_.at(index).evaluate(outputs, roll_angle_rad);
    return {risk.level, risk.direction, risk.opposite};
}

}  // namespace sil
