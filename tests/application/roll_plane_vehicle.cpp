#include "tests/application/roll_plane_vehicle.hpp"

#include <cmath>

namespace testing_application {
namespace {

constexpr double gravity_mps2 = 9.80665;
constexpr double degrees_per_radian = 57.295779513082321;

}  // namespace

double RollPlaneVehicle::roll_rate_radps() const {
    const double arm_m = static_cast<double>(parameters_.sprung_cg_height_m) -
                         static_cast<double>(parameters_.fixed_roll_centre_height_m);
    const double force_n = static_cast<double>(parameters_.sprung_mass_kg) *
                           (acceleration_mps2_ + gravity_mps2 * std::tan(angle_rad_));
    return (arm_m * force_n - static_cast<double>(parameters_.roll_stiffness_nmprad) * angle_rad_) /
           static_cast<double>(parameters_.roll_damping_nmsprad);
}

void RollPlaneVehicle::advance(double lateral_acceleration_mps2) {
    constexpr int steps = 10;
    const double from_mps2 = acceleration_mps2_;
    for (int step = 1; step <= steps; ++step) {
        angle_rad_ += 0.001 * roll_rate_radps();
        acceleration_mps2_ = from_mps2 + (lateral_acceleration_mps2 - from_mps2) * step / steps;
    }
}

Motion RollPlaneVehicle::motion() const {
    const double sine = std::sin(angle_rad_);
    const double cosine = std::cos(angle_rad_);
    Motion motion;
    motion.imu.lateral_acceleration_mps2 =
        static_cast<float>(acceleration_mps2_ * cosine + gravity_mps2 * sine);
    motion.imu.vertical_acceleration_mps2 =
        static_cast<float>(gravity_mps2 * cosine - acceleration_mps2_ * sine);
    motion.imu.roll_rate_deg_per_s = static_cast<float>(roll_rate_radps() * degrees_per_radian);
    motion.roll_angle.roll_angle_deg = static_cast<float>(angle_rad_ * degrees_per_radian);
    // A sensor that lives moves: the speed falls a little in a turn, the steering is the one that asks for
    // it.
    motion.vehicle_motion.speed_kmh = static_cast<float>(80.0 - 0.05 * std::abs(acceleration_mps2_));
    constexpr double speed_mps = 80.0 / 3.6;
    motion.vehicle_motion.yaw_rate_deg_per_s =
        static_cast<float>(acceleration_mps2_ / speed_mps * degrees_per_radian);
    const double curvature = static_cast<double>(parameters_.wheelbase_m) / (speed_mps * speed_mps) +
                             static_cast<double>(parameters_.understeer_gradient_s2pm);
    motion.vehicle_motion.steering_wheel_angle_deg =
        static_cast<float>(acceleration_mps2_ * curvature * static_cast<double>(parameters_.steering_ratio) *
                           degrees_per_radian);
    return motion;
}

double RollPlaneVehicle::threshold_mps2() const {
    const double height_m = static_cast<double>(parameters_.sprung_cg_height_m);
    const double arm_m = height_m - static_cast<double>(parameters_.fixed_roll_centre_height_m);
    const double half_track_m = 0.5 * static_cast<double>(parameters_.track_width_m);
    const double side = acceleration_mps2_ < 0.0 ? -1.0 : 1.0;
    return side * gravity_mps2 * (half_track_m - side * arm_m * std::tan(angle_rad_)) / height_m;
}

}  // namespace testing_application
