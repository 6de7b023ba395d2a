#include "sil/world/sensors/sensor_suite.hpp"

#include <algorithm>
#include <cmath>

namespace sil {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<Vector, 3> housing_axes(const MountingTilt& tilt) {
    const double cosine_yaw = std::cos(tilt.yaw_rad);
    const double sine_yaw = std::sin(tilt.yaw_rad);
    const double cosine_pitch = std::cos(tilt.pitch_rad);
    const double sine_pitch = std::sin(tilt.pitch_rad);
    const double cosine_roll = std::cos(tilt.roll_rad);
    const double sine_roll = std::sin(tilt.roll_rad);
    const Vector x{cosine_yaw * cosine_pitch, sine_yaw * cosine_pitch, -sine_pitch};
    const Vector y{cosine_yaw * sine_pitch * sine_roll - sine_yaw * cosine_roll,
                   sine_yaw * sine_pitch * sine_roll + cosine_yaw * cosine_roll, cosine_pitch * sine_roll};
    return {x, y, cross(x, y)};
}

}  // namespace

std::array<double, 3> specific_force_at(const Truth& truth, const MountingPosition& position) {
    const Vector r{position.x_m, position.y_m, position.z_m};
    const Vector& omega = truth.angular_velocity_radps;
    const Vector tangential = cross(truth.angular_acceleration_radps2, r);
    const Vector centripetal = cross(omega, cross(omega, r));
    const Vector& f_cg = truth.specific_force_mps2;
    return {f_cg[0] + tangential[0] + centripetal[0], f_cg[1] + tangential[1] + centripetal[1],
            f_cg[2] + tangential[2] + centripetal[2]};
}

Imu::Imu(const ImuOptions& options, std::uint64_t seed)
    : position_(options.position),
      tilted_(options.tilt.roll_rad != 0.0 || options.tilt.pitch_rad != 0.0 || options.tilt.yaw_rad != 0.0),
      axes_(housing_axes(options.tilt)),
      averaged_(options.averaged),
      lateral_(options.lateral_acceleration_mps2, seed, NoiseStream::lateral_acceleration),
      vertical_(options.vertical_acceleration_mps2, seed, NoiseStream::vertical_acceleration),
      roll_rate_(options.roll_rate_radps, seed, NoiseStream::roll_rate) {}

void Imu::observe(const Truth& truth) {
    const Vector force = specific_force_at(truth, position_);
    if (!averaged_) {
        lateral_sum_mps2_ = vertical_sum_mps2_ = roll_rate_sum_radps_ = 0.0;
        observed_ = 0;
    }
    const Vector& rate = truth.angular_velocity_radps;
    lateral_sum_mps2_ += tilted_ ? dot(axes_[1], force) : force[1];
    vertical_sum_mps2_ += tilted_ ? dot(axes_[2], force) : force[2];
    roll_rate_sum_radps_ += tilted_ ? dot(axes_[0], rate) : rate[0];
    ++observed_;
}

void Imu::report(SensorSample& sample) {
    const double count = observed_ > 0 ? observed_ : SensorSample::not_available;
    sample.lateral_acceleration_mps2 = lateral_.measure(lateral_sum_mps2_ / count);
    sample.vertical_acceleration_mps2 = vertical_.measure(vertical_sum_mps2_ / count);
    sample.roll_rate_radps = roll_rate_.measure(roll_rate_sum_radps_ / count);

    lateral_sum_mps2_ = 0.0;
    vertical_sum_mps2_ = 0.0;
    roll_rate_sum_radps_ = 0.0;
    observed_ = 0;
}

RollSensor::RollSensor(const RollSensorOptions& options, std::uint64_t seed)
    : reference_(options.reference),
      reports_bank_(options.reports_bank),
      roll_angle_(options.roll_angle_rad, seed, NoiseStream::roll_angle),
      bank_angle_(options.bank_angle_rad, seed, NoiseStream::bank_angle) {}

void RollSensor::report(const Truth& truth, SensorSample& sample) {
    const bool against_horizon = reference_ == RollReference::horizon;
    sample.roll_angle_rad =
        roll_angle_.measure(against_horizon ? truth.roll_to_horizon_rad : truth.roll_angle_rad);
    sample.bank_angle_rad =
        reports_bank_ ? bank_angle_.measure(truth.bank_angle_rad) : SensorSample::not_available;
}

VehicleMotionSensor::VehicleMotionSensor(const VehicleMotionOptions& options, std::uint64_t seed)
    : speed_(options.speed_mps, seed, NoiseStream::speed),
      yaw_rate_(options.yaw_rate_radps, seed, NoiseStream::yaw_rate),
      steering_wheel_angle_(options.steering_wheel_angle_rad, seed, NoiseStream::steering_wheel_angle) {}

void VehicleMotionSensor::report(const Truth& truth, SensorSample& sample) {
    sample.speed_mps = std::max(speed_.measure(truth.speed_mps), 0.0);
    sample.yaw_rate_radps = yaw_rate_.measure(truth.angular_velocity_radps[2]);
    sample.steering_wheel_angle_rad = steering_wheel_angle_.measure(truth.steering_wheel_angle_rad);
}

SensorSuite::SensorSuite(const SensorOptions& options)
    : imu_(options.imu, options.seed),
      roll_(options.roll, options.seed),
      motion_(options.motion, options.seed),
      mass_(options.mass) {}

void SensorSuite::observe(const Truth& truth) {
    imu_.observe(truth);
}

SensorSample SensorSuite::report(const Truth& truth) {
    SensorSample sample;
    sample.time_s = truth.time_s;
    imu_.report(sample);
    roll_.report(truth, sample);
    motion_.report(truth, sample);
    if (mass_.fitted) {
        sample.vehicle_mass_kg = truth.mass_kg * (1.0 + mass_.scale_error);
    }
    return sample;
}

}  // namespace sil
