// Driveline and brakes: the torques on the wheels that driver, differentials, brakes and rolling cause.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "sil/world/vehicle/driver_input.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// What is left of the drive of an axle both of whose wheels spin: all of it while the slower one is up to 2
// m/s and a fifth faster than the vehicle, nothing at twice that. No driver, engine or traction control lets
// it run away; and wheels that did would tilt the turning vehicle as gyroscopes.
inline double traction_share(double rim_speed_mps, double speed_mps) {
    const double allowed = 2.0 + 0.2 * std::abs(speed_mps);
    return std::clamp(2.0 - (rim_speed_mps - std::abs(speed_mps)) / allowed, 0.0, 1.0);
}

// Drive torque of each wheel. Each axle has a differential that resists a difference of speeds, so that a
// lifted wheel does not run away with all the power. `speed_mps`: forward.
inline std::array<double, wheel_count> drive_torques_nm(const DrivelineParameters& parameters,
                                                        double drive_force_n, double wheel_radius_m,
                                                        double speed_mps,
                                                        const std::array<double, wheel_count>& spin_radps) {
    const double limit = parameters.drive_force_limit_n;
    const double half_torque = 0.5 * std::clamp(drive_force_n, -limit, limit) * wheel_radius_m;
    const auto share = [&](Wheel left, Wheel right) {
        const double rim_mps = wheel_radius_m * std::min(spin_radps[left], spin_radps[right]);
        return half_torque > 0.0 ? traction_share(rim_mps, speed_mps) : 1.0;
    };
    const double to_front = half_torque * parameters.front_drive_share;
    const double front = to_front * share(front_left, front_right);
    const double rear = (half_torque - to_front) * share(rear_left, rear_right);
    const double front_lock =
        0.5 * parameters.differential_damping_nmsprad * (spin_radps[front_left] - spin_radps[front_right]);
    const double rear_lock =
        0.5 * parameters.differential_damping_nmsprad * (spin_radps[rear_left] - spin_radps[rear_right]);
    return {front - front_lock, front + front_lock, rear - rear_lock, rear + rear_lock};
}

// Torque of dry friction (brake, rolling resistance): opposes rotation, and holds the wheel at rest rather
// than turning it backwards. `free_torque_nm`: all other torques.
inline double friction_torque_nm(double largest_nm, double spin_radps, double free_torque_nm,
                                 double inertia_kgm2, double step_s) {
    const double stopping = -(inertia_kgm2 * spin_radps / step_s + free_torque_nm);
    return std::clamp(stopping, -largest_nm, largest_nm);
}

}  // namespace sil
