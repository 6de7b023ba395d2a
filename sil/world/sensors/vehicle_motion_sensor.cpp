// VehicleMotionSensor: speed, yaw rate and steering with their errors.
#include "sil/world/sensors/vehicle_motion_sensor.hpp"

#include <algorithm>

namespace sil {

VehicleMotionSensor::VehicleMotionSensor(const VehicleMotionOptions& options, std::uint64_t seed)
    : speed_(options.speed_mps, seed, NoiseStream::speed),
      yaw_rate_(options.yaw_rate_radps, seed, NoiseStream::yaw_rate),
      steering_wheel_angle_(options.steering_wheel_angle_rad, seed, NoiseStream::steering_wheel_angle) {}

void VehicleMotionSensor::report(const Truth& truth, SensorSample& sample) {
    sample.speed_mps = std::max(speed_.measure(truth.speed_mps), 0.0);
    sample.yaw_rate_radps = yaw_rate_.measure(truth.angular_velocity_radps[2]);
    sample.steering_wheel_angle_rad = steering_wheel_angle_.measure(truth.steering_wheel_angle_rad);
}

}  // namespace sil
