#include "rsi/indicator/indicator_level.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

float static_stability_factor(const Parameters& parameters) {
    return parameters.track_width_m / (2.0F * parameters.sprung_cg_height_m);
}

float at_most_20(float level) {
    return (level > 20.0F) ? 20.0F : level;  // a number that is not available stays so
}

// Most outputs are bounded already.
float raw_level(const Outputs& outputs, const Parameters& parameters) {
    switch (static_cast<rsi_indicator>(parameters.warning_indicator)) {
        case RSI_INDICATOR_PUBLISHED:
            return outputs.rsi;
        case RSI_INDICATOR_BANK_FREE:
            return outputs.rsi_bank_free;
        case RSI_INDICATOR_EXTENDED:
            return outputs.rsi_extended;
        case RSI_INDICATOR_LOAD_TRANSFER:
            return absolute(outputs.load_transfer_ratio);
        case RSI_INDICATOR_PREDICTED_LOAD_TRANSFER:
            return absolute(outputs.predicted_load_transfer_ratio);
        case RSI_INDICATOR_PREDICTED_RSI:
            return outputs.predicted_rsi;
        case RSI_INDICATOR_STATIC_STABILITY_FACTOR:
            return outputs.static_stability_level;
        case RSI_INDICATOR_DYNAMIC_STABILITY:
            return at_most_20(absolute(outputs.dynamic_stability_index) /
                              static_stability_factor(parameters));
        case RSI_INDICATOR_DYNAMIC_STABILITY_LATE:
            return at_most_20(absolute(outputs.dynamic_stability_index_late) /
                              static_stability_factor(parameters));
        case RSI_INDICATOR_ENERGY:
            return at_most_20(1.0F - outputs.energy_margin);
        case RSI_INDICATOR_ROLLOVER_INDEX:
            return outputs.rollover_index;
        case RSI_INDICATOR_TIME_TO_ROLLOVER:
            return is_finite(outputs.time_to_rollover_s)
                       ? at_most_20(parameters.time_to_rollover_limit_s /
                                    larger(outputs.time_to_rollover_s, 0.01F))
                       : not_available;
    }
    return not_available;
}

float signed_indicator(const Outputs& outputs, const Parameters& parameters, float roll_angle_rad) {
    switch (static_cast<rsi_indicator>(parameters.warning_indicator)) {
        case RSI_INDICATOR_PUBLISHED:
        case RSI_INDICATOR_BANK_FREE:
        case RSI_INDICATOR_EXTENDED:
            return outputs.road_parallel_force_mps2;
        case RSI_INDICATOR_LOAD_TRANSFER:
            return outputs.load_transfer_ratio;
        case RSI_INDICATOR_PREDICTED_LOAD_TRANSFER:
        case RSI_INDICATOR_PREDICTED_RSI:
            return outputs.predicted_load_transfer_ratio;
        case RSI_INDICATOR_STATIC_STABILITY_FACTOR:
            return outputs.lateral_acceleration_mps2;
        case RSI_INDICATOR_DYNAMIC_STABILITY:
            return outputs.dynamic_stability_index;
        case RSI_INDICATOR_DYNAMIC_STABILITY_LATE:
            return outputs.dynamic_stability_index_late;
        case RSI_INDICATOR_ENERGY:
        case RSI_INDICATOR_ROLLOVER_INDEX:
        case RSI_INDICATOR_TIME_TO_ROLLOVER:
            return roll_angle_rad;
    }
    return 0.0F;
}

}  // namespace

float indicator_level(const Outputs& outputs, const Parameters& parameters) {
    return raw_level(outputs, parameters);
}

float indicator_side(const Outputs& outputs, const Parameters& parameters, float roll_angle_rad) {
    return (signed_indicator(outputs, parameters, roll_angle_rad) < 0.0F) ? -1.0F : 1.0F;
}

}  // namespace rsi
