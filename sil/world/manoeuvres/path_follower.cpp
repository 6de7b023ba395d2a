// Path follower: preview steering.
#include "sil/world/manoeuvres/path_follower.hpp"

#include <algorithm>
#include <cmath>

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {
namespace {

constexpr double smallest_speed_mps = 3.0;
constexpr double largest_handwheel_rad = from_degrees(540.0);

}  // namespace

double PathFollower::preview_m(const Truth& truth) const {
    return preview_s_ * std::max(truth.speed_mps, smallest_speed_mps);
}

double PathFollower::handwheel_rad(const Truth& truth, const PathPoint& target) const {
    const double speed = std::max(truth.speed_mps, smallest_speed_mps);
    const double course = truth.yaw_angle_rad + std::atan2(truth.lateral_velocity_mps, speed);
    const double ahead_x = target.x_m - truth.position_x_m;
    const double ahead_y = target.y_m - truth.position_y_m;
    const double to_the_left = ahead_y * std::cos(course) - ahead_x * std::sin(course);
    const double curvature_pm = 2.0 * to_the_left / std::max(1.0, ahead_x * ahead_x + ahead_y * ahead_y);
    const double wanted = ratio_ * curvature_pm * (wheelbase_m_ + understeer_gradient_s2pm_ * speed * speed);
    return std::clamp(wanted, -largest_handwheel_rad, largest_handwheel_rad);
}

double understeer_gradient_s2pm(const VehicleParameters& parameters, double handwheel_at_0_3_g_rad) {
    const double speed = from_mph(50.0);
    return handwheel_at_0_3_g_rad / (parameters.steering.ratio * 0.3 * gravity_mps2) -
           wheelbase_m(parameters.geometry) / (speed * speed);
}

}  // namespace sil
