// Component inputs: which value of a sensor sample is which input of the component, where no bus is between
// them.
#pragma once

#include <iterator>

#include "rsi/rsi.h"
#include "sil/world/sensors/sensor_sample.hpp"

namespace sil {

struct ComponentInput {
    const char* name;
    float rsi_inputs::* input;
    double SensorSample::* measured;
    const char* meaning;
};

inline constexpr ComponentInput component_inputs[] = {
    {"lateral_specific_force_mps2", &rsi_inputs::lateral_specific_force_mps2,
     &SensorSample::lateral_acceleration_mps2,
     "what an accelerometer fixed to the body shows to the left; needed"},
    {"vertical_specific_force_mps2", &rsi_inputs::vertical_specific_force_mps2,
     &SensorSample::vertical_acceleration_mps2, "what it shows upwards, about +9.81 at rest"},
    {"roll_rate_radps", &rsi_inputs::roll_rate_radps, &SensorSample::roll_rate_radps,
     "about the body's x axis; needed"},
    {"roll_angle_rad", &rsi_inputs::roll_angle_rad, &SensorSample::roll_angle_rad,
     "of the body, against roll_angle_reference"},
    {"yaw_rate_radps", &rsi_inputs::yaw_rate_radps, &SensorSample::yaw_rate_radps, "about the body's z axis"},
    {"bank_angle_rad", &rsi_inputs::bank_angle_rad, &SensorSample::bank_angle_rad,
     "of the road, left side up is positive"},
    {"speed_mps", &rsi_inputs::speed_mps, &SensorSample::speed_mps, "forward"},
    {"steering_wheel_angle_rad", &rsi_inputs::steering_wheel_angle_rad,
     &SensorSample::steering_wheel_angle_rad, "at the handwheel, positive to the left"},
    {"vehicle_mass_kg", &rsi_inputs::vehicle_mass_kg, &SensorSample::vehicle_mass_kg,
     "of the whole vehicle with its load"},
};
static_assert(sizeof(rsi_inputs) == sizeof(float) * std::size(component_inputs), "an input has no row");

inline rsi_inputs to_inputs(const SensorSample& sample) {
    rsi_inputs inputs{};
    for (const ComponentInput& each : component_inputs) {
        inputs.*each.input = static_cast<float>(sample.*each.measured);
    }
    return inputs;
}

}  // namespace sil
