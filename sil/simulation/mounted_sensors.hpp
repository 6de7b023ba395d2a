// Mounted sensors: the sensors' options with the IMU where the vehicle's parameter file puts it.
#pragma once

#include <cstdint>

#include "sil/sensors/sensor_options.hpp"
#include "sil/vehicle/parameters.hpp"

namespace sil {

inline SensorOptions mounted_sensors(const VehicleParameters& vehicle, bool noise, std::uint64_t seed) {
    SensorOptions options = noise ? noisy_sensors(seed) : SensorOptions{};
    options.imu.position = {vehicle.imu_mount.x_m, vehicle.imu_mount.y_m, vehicle.imu_mount.z_m};
    return options;
}

}  // namespace sil
