#include "rsi/warning/indicator_level.hpp"

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

float at_most_20(float level) {
    return (level > 20.0F) ? 20.0F : level;  // a number that is not available stays so
}

}  // namespace

WarningIndicator::WarningIndicator(const Parameters& parameters)
    : indicator_(parameters.warning_indicator),
      static_stability_inverse_(1.0F / static_stability_factor(parameters)),
      time_to_rollover_limit_s_(parameters.time_to_rollover_limit_s) {}

IndicatedRisk WarningIndicator::evaluate(const Outputs& outputs, float roll_angle_rad) const {
    if ((indicator_ < 0) || (indicator_ >= static_cast<std::int32_t>(index_outputs.size()))) {
        return {not_available, 0.0F, 0.0F};
    }
    const IndexOutput& index = index_outputs[static_cast<std::size_t>(indicator_)];
    const float value = outputs.*index.member;
    const float opposite = (index.side == RiskSide::both) ? outputs.opposite_load_transfer_ratio : 0.0F;
    return {at_most_20(level(index.scale, value)), direction(index.side, value, outputs, roll_angle_rad),
            opposite};
}

float WarningIndicator::level(LevelScale scale, float value) const {
    if (scale == LevelScale::same) {
        return value;
    }
    if (scale == LevelScale::magnitude) {
        return absolute(value);
    }
    if (scale == LevelScale::per_ssf) {
        return absolute(value) * static_stability_inverse_;
    }
    if (scale == LevelScale::complement) {
        return 1.0F - value;
    }
    // LevelScale::limit_over. A value that is not available must not become the largest risk.
    return is_finite(value) ? time_to_rollover_limit_s_ / larger(value, 0.01F) : not_available;
}

float WarningIndicator::direction(RiskSide side, float value, const Outputs& outputs, float roll_angle_rad) {
    if ((side == RiskSide::own) || (side == RiskSide::both)) {
        return value;
    }
    if (side == RiskSide::force) {
        return outputs.road_parallel_force_mps2;
    }
    if (side == RiskSide::acceleration) {
        return outputs.lateral_acceleration_mps2;
    }
    if (side == RiskSide::predicted) {
        return outputs.predicted_load_transfer_ratio;
    }
    return roll_angle_rad;  // RiskSide::roll
}

float indicator_level(const Outputs& outputs, const Parameters& parameters) {
    return WarningIndicator{parameters}.evaluate(outputs, 0.0F).level;
}

}  // namespace rsi
