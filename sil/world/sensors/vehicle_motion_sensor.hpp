// VehicleMotionSensor: speed, yaw rate and steering wheel angle, as a car's gateway offers them.
#pragma once

#include <cstdint>

#include "sil/world/sensors/sensor_channel.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

class VehicleMotionSensor {
 public:
    VehicleMotionSensor(const VehicleMotionOptions& options, std::uint64_t seed);

    // Writes the values of this instant. Speed comes from wheel speeds and so has no sign: it ends at zero.
    // The yaw rate is that about the body's own z axis, which is where the gyro is mounted.
    void report(const Truth& truth, SensorSample& sample);

 private:
    SensorChannel speed_;
    SensorChannel yaw_rate_;
    SensorChannel steering_wheel_angle_;
};

}  // namespace sil
