// Sensor columns: the values of the sensors as columns of a CSV file, of a run and of a replayed drive.
#pragma once

#include "sil/files/csv_writer.hpp"
#include "sil/units.hpp"
#include "sil/world/sensors/sensor_sample.hpp"

namespace sil {

// clang-format off
inline constexpr CsvColumn<SensorSample> sensor_columns[] = {
    {"sensor_lateral_acceleration_mps2", [](const SensorSample& sample) { return sample.lateral_acceleration_mps2; }},
    {"sensor_vertical_acceleration_mps2", [](const SensorSample& sample) { return sample.vertical_acceleration_mps2; }},
    {"sensor_roll_rate_degps", [](const SensorSample& sample) { return sample.roll_rate_radps * degrees_per_radian; }},
    {"sensor_roll_angle_deg", [](const SensorSample& sample) { return sample.roll_angle_rad * degrees_per_radian; }},
    {"sensor_bank_angle_deg", [](const SensorSample& sample) { return sample.bank_angle_rad * degrees_per_radian; }},
    {"sensor_speed_mps", [](const SensorSample& sample) { return sample.speed_mps; }},
    {"sensor_yaw_rate_degps", [](const SensorSample& sample) { return sample.yaw_rate_radps * degrees_per_radian; }},
    {"sensor_steering_wheel_angle_deg", [](const SensorSample& sample) { return sample.steering_wheel_angle_rad * degrees_per_radian; }},
};
// clang-format on

}  // namespace sil
