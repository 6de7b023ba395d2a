#include "sil/studies/drives/frame_samples.hpp"

#include "can_dbc/generated/rollover_warning.hpp"
#include "sil/files/sensor_frame.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double kmh_per_mps = 3.6;

double radians(float degrees) {
    return static_cast<double>(degrees) / degrees_per_radian;
}

}  // namespace

SensorSample sensor_sample(const DriveSample& sample) {
    SensorSample result;
    result.time_s = sample.time_s;
    result.lateral_acceleration_mps2 = sample.lateral_specific_force_mps2;
    result.vertical_acceleration_mps2 = sample.vertical_specific_force_mps2;
    result.roll_rate_radps = sample.roll_rate_radps;
    result.roll_angle_rad = sample.roll_angle_rad;
    result.bank_angle_rad = sample.bank_angle_rad;
    result.speed_mps = sample.speed_mps;
    result.yaw_rate_radps = sample.yaw_rate_radps;
    result.steering_wheel_angle_rad = sample.steering_wheel_angle_rad;
    result.vehicle_mass_kg = sample.vehicle_mass_kg;
    return result;
}

void take_frame(const hal::CanFrame& frame, DriveSample& sample) {
    if (!is_sensor_frame(frame)) {
        return;
    }
    if (frame.identifier == can_dbc::Imu::identifier && frame.length == can_dbc::Imu::length) {
        const can_dbc::Imu imu = can_dbc::decode<can_dbc::Imu>(frame.data).value;
        sample.lateral_specific_force_mps2 = static_cast<double>(imu.lateral_acceleration_mps2);
        sample.vertical_specific_force_mps2 = static_cast<double>(imu.vertical_acceleration_mps2);
        sample.roll_rate_radps = radians(imu.roll_rate_deg_per_s);
    } else if (frame.identifier == can_dbc::RollAngle::identifier &&
               frame.length == can_dbc::RollAngle::length) {
        const can_dbc::RollAngle roll = can_dbc::decode<can_dbc::RollAngle>(frame.data).value;
        sample.roll_angle_rad = radians(roll.roll_angle_deg);
        sample.bank_angle_rad = radians(roll.bank_angle_deg);
    } else if (frame.identifier == can_dbc::VehicleMotion::identifier &&
               frame.length == can_dbc::VehicleMotion::length) {
        const can_dbc::VehicleMotion motion = can_dbc::decode<can_dbc::VehicleMotion>(frame.data).value;
        sample.speed_mps = static_cast<double>(motion.speed_kmh) / kmh_per_mps;
        sample.yaw_rate_radps = radians(motion.yaw_rate_deg_per_s);
        sample.steering_wheel_angle_rad = radians(motion.steering_wheel_angle_deg);
    } else if (frame.identifier == can_dbc::VehicleMass::identifier &&
               frame.length == can_dbc::VehicleMass::length) {
        const can_dbc::VehicleMass mass = can_dbc::decode<can_dbc::VehicleMass>(frame.data).value;
        sample.vehicle_mass_kg = static_cast<double>(mass.mass_kg);
    }
}

}  // namespace sil
