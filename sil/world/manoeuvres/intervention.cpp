#include "sil/world/manoeuvres/intervention.hpp"

#include <algorithm>

namespace sil {
namespace {

constexpr double rounding_s = 1.0e-6;  // times are sums of steps

double brake_for(double deceleration_mps2, const VehicleParameters& vehicle) {
    const double most_n = 2.0 * (vehicle.driveline.front_brake_nm + vehicle.driveline.rear_brake_nm) /
                          vehicle.geometry.wheel_radius_m;
    const double wanted_n = deceleration_mps2 * total_mass_kg(vehicle);
    return wanted_n < most_n ? wanted_n / most_n : 1.0;
}

}  // namespace

InterventionEffect::InterventionEffect(const Intervention& intervention, const VehicleParameters& vehicle)
    : intervention_{intervention}, whole_brake_{brake_for(intervention.deceleration_mps2, vehicle)} {}

void InterventionEffect::demand(bool wanted, double time_s) {
    if (wanted != demanded_) {
        demanded_ = wanted;
        ahead_.push_back({wanted, time_s});
    }
}

DriverCommand InterventionEffect::changed(DriverCommand command, double time_s) {
    const double since_s = time_s - last_s_;
    last_s_ = time_s;
    while (!ahead_.empty() && time_s > ahead_.front().time_s + intervention_.delay_s - rounding_s) {
        acts_ = ahead_.front().wanted;
        times_ += acts_ ? 1U : 0U;
        ahead_.pop_front();
    }
    const double most_change = intervention_.ramp_s > 0.0 ? since_s / intervention_.ramp_s : 1.0;
    effect_ = std::clamp(effect_ + (acts_ ? most_change : -most_change), 0.0, 1.0);
    if (effect_ <= 0.0) {
        return command;
    }
    acted_s_ += since_s;
    command.speed_policy = SpeedPolicy::off_throttle;
    if (intervention_.kind == InterventionKind::brake) {
        command.brake = std::max(command.brake, effect_ * whole_brake_);
    } else {
        command.steering_wheel_angle_rad *= 1.0 - effect_ * intervention_.steer_back_share;
    }
    return command;
}

}  // namespace sil
