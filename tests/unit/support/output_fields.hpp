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
};

static_assert(sizeof(rsi_outputs) == sizeof(rsi_state) + sizeof(rsi_side) +
                                         sizeof(float) * (sizeof(output_fields) / sizeof(OutputField)),
              "every number of rsi_outputs belongs in the table");

inline std::uint32_t bits_of(float value) {
    std::uint32_t bits = 0U;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
}

inline bool all_finite(const rsi_outputs& outputs) {
    for (const OutputField& field : output_fields) {
        if (!std::isfinite(outputs.*field.member)) {
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
    if ((a.state != b.state) || (a.side != b.side)) {
        return ::testing::AssertionFailure() << "state or side differ";
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
