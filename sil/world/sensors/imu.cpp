// Imu: lever arm and decimation.
#include "sil/world/sensors/imu.hpp"

namespace sil {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
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
    lateral_sum_mps2_ += force[1];
    vertical_sum_mps2_ += force[2];
    roll_rate_sum_radps_ += truth.angular_velocity_radps[0];
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

}  // namespace sil
