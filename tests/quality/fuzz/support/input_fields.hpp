// The component's inputs: which there are, and from which value on each counts as not available.
#pragma once

#include <cmath>

#include "rsi/rsi.h"

namespace fuzz {

struct InputField {
    float rsi_inputs::* member;
    float limit;  // beyond it a value is not available
    bool turns_with_the_mirror;
};

inline constexpr InputField input_fields[] = {
    {&rsi_inputs::lateral_specific_force_mps2, 60.0F, true},
    {&rsi_inputs::vertical_specific_force_mps2, 60.0F, false},
    {&rsi_inputs::roll_rate_radps, 10.0F, true},
    {&rsi_inputs::roll_angle_rad, 2.2F, true},
    {&rsi_inputs::yaw_rate_radps, 10.0F, true},
    {&rsi_inputs::bank_angle_rad, 0.8F, true},
    {&rsi_inputs::speed_mps, 150.0F, false},
    {&rsi_inputs::steering_wheel_angle_rad, 30.0F, true},
    {&rsi_inputs::vehicle_mass_kg, 60000.0F, false},
};
inline constexpr unsigned input_count = sizeof input_fields / sizeof input_fields[0];

inline bool is_available(float value, float limit) {
    return std::isfinite(value) && std::fabs(value) <= limit;
}

}  // namespace fuzz
