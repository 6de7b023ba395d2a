#include "sil/studies/faults/output_ranges.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sil {
namespace {

bool is_within(float value, double low, double high) {
    const auto number = static_cast<double>(value);
    return number >= low && number <= high;
}

// What could not be computed is NaN.
bool is_within_if_known(float value, double low, double high) {
    return std::isnan(value) || is_within(value, low, high);
}

}  // namespace

bool are_in_range(const rsi::Outputs& outputs) {
    const std::array numbers{
        outputs.rsi,
        outputs.rsi_bank_free,
        outputs.road_parallel_force_mps2,
        outputs.road_normal_force_mps2,
        outputs.fixed_model_roll_angle_rad,
        outputs.compensated_roll_angle_rad,
        outputs.additional_roll_moment_nm,
        outputs.roll_centre_vertical_m,
        outputs.roll_centre_lateral_m,
        outputs.roll_stiffness_deviation_nmprad,
        outputs.roll_damping_deviation_nmsprad,
        outputs.disturbance_nm,
        outputs.roll_centre_deviation_m,
        outputs.observed_roll_angle_rad,
        outputs.observed_bank_angle_rad,
        outputs.rsi_extended,
        outputs.load_transfer_ratio,
        outputs.predicted_load_transfer_ratio,
        outputs.predicted_rsi,
        outputs.static_stability_level,
        outputs.dynamic_stability_index,
        outputs.dynamic_stability_index_late,
        outputs.energy_margin,
        outputs.rollover_index,
        outputs.time_to_rollover_s,
    };
    const bool finite =
        std::none_of(numbers.begin(), numbers.end(), [](float number) { return std::isinf(number); });
    if (outputs.state == RSI_STATE_UNAVAILABLE) {
        return finite;
    }
    return finite && is_within(outputs.warning_level, 0.0, 20.0) &&
           is_within(outputs.lateral_acceleration_mps2, -100.0, 100.0) &&
           is_within_if_known(outputs.roll_centre_deviation_m, 0.0, 0.5) &&
           is_within_if_known(outputs.roll_centre_vertical_m, -1.0, 1.0);
}

}  // namespace sil
