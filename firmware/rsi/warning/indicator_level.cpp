#include "rsi/warning/indicator_level.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

float at_most_20(float level) {
    return (level > 20.0F) ? 20.0F : level;  // a number that is not available stays so
}

}  // namespace

void WarningIndicator::init(const Parameters& parameters) {
    indicator_ = static_cast<rsi_indicator>(parameters.warning_indicator);
    static_stability_inverse_ = 2.0F * parameters.sprung_cg_height_m / parameters.track_width_m;
    time_to_rollover_limit_s_ = parameters.time_to_rollover_limit_s;
}

// Most outputs are bounded already.
IndicatedRisk WarningIndicator::evaluate(const Outputs& outputs, float roll_angle_rad) const {
    switch (indicator_) {
        case RSI_INDICATOR_PUBLISHED:
            return {outputs.rsi, outputs.road_parallel_force_mps2};
        case RSI_INDICATOR_BANK_FREE:
            return {outputs.rsi_bank_free, outputs.road_parallel_force_mps2};
        case RSI_INDICATOR_EXTENDED:
            return {outputs.rsi_extended, outputs.road_parallel_force_mps2};
        case RSI_INDICATOR_LOAD_TRANSFER:
            return {absolute(outputs.load_transfer_ratio), outputs.load_transfer_ratio};
        case RSI_INDICATOR_PREDICTED_LOAD_TRANSFER:
            return {absolute(outputs.predicted_load_transfer_ratio), outputs.predicted_load_transfer_ratio};
        case RSI_INDICATOR_PREDICTED_RSI:
            return {outputs.predicted_rsi, outputs.predicted_load_transfer_ratio};
        case RSI_INDICATOR_STATIC_STABILITY_FACTOR:
            return {outputs.static_stability_level, outputs.lateral_acceleration_mps2};
        case RSI_INDICATOR_DYNAMIC_STABILITY:
            return {at_most_20(absolute(outputs.dynamic_stability_index) * static_stability_inverse_),
                    outputs.dynamic_stability_index};
        case RSI_INDICATOR_DYNAMIC_STABILITY_LATE:
            return {at_most_20(absolute(outputs.dynamic_stability_index_late) * static_stability_inverse_),
                    outputs.dynamic_stability_index_late};
        case RSI_INDICATOR_ENERGY:
            return {at_most_20(1.0F - outputs.energy_margin), roll_angle_rad};
        case RSI_INDICATOR_ROLLOVER_INDEX:
            return {outputs.rollover_index, roll_angle_rad};
        case RSI_INDICATOR_TIME_TO_ROLLOVER:
            // A time that is not available must not become the largest risk.
            return {is_finite(outputs.time_to_rollover_s)
                        ? at_most_20(time_to_rollover_limit_s_ / larger(outputs.time_to_rollover_s, 0.01F))
                        : not_available,
                    roll_angle_rad};
    }
    return {not_available, 0.0F};
}

float indicator_level(const Outputs& outputs, const Parameters& parameters) {
    WarningIndicator indicator;
    indicator.init(parameters);
    return indicator.evaluate(outputs, 0.0F).level;
}

}  // namespace rsi
