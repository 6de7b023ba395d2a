// Mounted sensors: the sensors' options with the IMU where the vehicle's parameter file puts it.
#pragma once

#include <cstdint>

#include "sil/units.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Faults of a run's sensors. The default is nothing.
struct SensorFlaws {
    bool noise{false};           // the preset of ordinary automotive sensors
    std::uint64_t seed{1U};      // of the noise
    double bias_g{0.0};          // of the accelerometers, on both axes
    double quantisation_g{0.0};  // least step of the accelerometers; the CAN frame has one of its own
    bool bank_sensor{false};     // the road's bank is measured, as few vehicles can
    // The roll angle is measured against the horizon, as most sensors do; the road's bank is in it.
    bool attitude_sensor{false};
    bool mass_sensor{false};  // the vehicle's mass is measured by its axle loads, as trucks do
};

inline SensorOptions mounted_sensors(const VehicleParameters& vehicle, const SensorFlaws& flaws) {
    SensorOptions options = flaws.noise ? noisy_sensors(flaws.seed) : SensorOptions{};
    options.imu.position = {vehicle.imu_mount.x_m, vehicle.imu_mount.y_m, vehicle.imu_mount.z_m};
    options.roll.reference = flaws.attitude_sensor ? RollReference::horizon : RollReference::road;
    options.mass.fitted = flaws.mass_sensor;
    options.roll.reports_bank = options.roll.reports_bank || flaws.bank_sensor;
    for (ChannelOptions* channel :
         {&options.imu.lateral_acceleration_mps2, &options.imu.vertical_acceleration_mps2}) {
        channel->bias = flaws.bias_g * g_mps2;
        channel->quantisation_step = flaws.quantisation_g * g_mps2;
    }
    return options;
}

}  // namespace sil
