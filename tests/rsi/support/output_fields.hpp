// The numbers of the outputs by name, and comparisons over all of them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "rsi/rsi.h"

namespace rsi_test {

struct OutputField {
    const char* name;
    float rsi_outputs::* member;
    bool turns_with_the_mirror;  // changes sign when left and right are exchanged
    bool optional{false};        // not available from the necessary inputs and the default calibration alone
};

inline constexpr OutputField output_fields[] = {
    {"rsi", &rsi_outputs::rsi, false},
    {"rsi_bank_free", &rsi_outputs::rsi_bank_free, false},
    {"lateral_acceleration_mps2", &rsi_outputs::lateral_acceleration_mps2, true},
    {"lateral_acceleration_threshold_mps2", &rsi_outputs::lateral_acceleration_threshold_mps2, true},
    {"road_parallel_force_mps2", &rsi_outputs::road_parallel_force_mps2, true},
    {"road_normal_force_mps2", &rsi_outputs::road_normal_force_mps2, false},
    {"fixed_model_roll_angle_rad", &rsi_outputs::fixed_model_roll_angle_rad, true},
    {"compensated_roll_angle_rad", &rsi_outputs::compensated_roll_angle_rad, true},
    {"additional_roll_moment_nm", &rsi_outputs::additional_roll_moment_nm, true},
    {"roll_centre_vertical_m", &rsi_outputs::roll_centre_vertical_m, false},
    {"roll_centre_lateral_m", &rsi_outputs::roll_centre_lateral_m, true},
    {"roll_stiffness_deviation_nmprad", &rsi_outputs::roll_stiffness_deviation_nmprad, false},
    {"roll_damping_deviation_nmsprad", &rsi_outputs::roll_damping_deviation_nmsprad, false},
    {"disturbance_nm", &rsi_outputs::disturbance_nm, true},
    {"warning_level", &rsi_outputs::warning_level, false},
    {"roll_centre_deviation_m", &rsi_outputs::roll_centre_deviation_m, false, true},
    {"observed_roll_angle_rad", &rsi_outputs::observed_roll_angle_rad, true, true},
    {"observed_bank_angle_rad", &rsi_outputs::observed_bank_angle_rad, true, true},
    {"rsi_extended", &rsi_outputs::rsi_extended, false, true},
    {"load_transfer_ratio", &rsi_outputs::load_transfer_ratio, true, true},
    {"predicted_load_transfer_ratio", &rsi_outputs::predicted_load_transfer_ratio, true, true},
    {"predicted_rsi", &rsi_outputs::predicted_rsi, false, true},
    {"static_stability_level", &rsi_outputs::static_stability_level, false, true},
    {"dynamic_stability_index", &rsi_outputs::dynamic_stability_index, true, true},
    {"dynamic_stability_index_late", &rsi_outputs::dynamic_stability_index_late, true, true},
    {"energy_margin", &rsi_outputs::energy_margin, false, true},
    {"rollover_index", &rsi_outputs::rollover_index, false, true},
    {"time_to_rollover_s", &rsi_outputs::time_to_rollover_s, false, true},
};

static_assert(sizeof(rsi_outputs) == sizeof(rsi_state) + sizeof(rsi_side) + sizeof(rsi_roll_source) +
                                         2U * sizeof(std::int32_t) +
                                         sizeof(float) * (sizeof(output_fields) / sizeof(OutputField)),
              "every number of rsi_outputs belongs in the table");

inline std::uint32_t bits_of(float value) {
    std::uint32_t bits = 0U;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
}

inline bool all_finite(const rsi_outputs& outputs) {
    for (const OutputField& field : output_fields) {
        if (!field.optional && !std::isfinite(outputs.*field.member)) {
            return false;
        }
    }
    return true;
}

inline bool all_not_available(const rsi_outputs& outputs) {
    for (const OutputField& field : output_fields) {
        if (!std::isnan(outputs.*field.member)) {
            return false;
        }
    }
    return true;
}

// The same state and the same bits.
inline ::testing::AssertionResult identical(const rsi_outputs& a, const rsi_outputs& b) {
    if ((a.state != b.state) || (a.side != b.side) || (a.roll_source != b.roll_source) ||
        (a.roll_sensor_disagrees != b.roll_sensor_disagrees) || (a.estimate_frozen != b.estimate_frozen)) {
        return ::testing::AssertionFailure() << "state, side, source or a flag differ";
    }
    for (const OutputField& field : output_fields) {
        if (bits_of(a.*field.member) != bits_of(b.*field.member)) {
            return ::testing::AssertionFailure()
                   << field.name << ": " << a.*field.member << " against " << b.*field.member;
        }
    }
    return ::testing::AssertionSuccess();
}

}  // namespace rsi_test
