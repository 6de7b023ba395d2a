// Driveline and brakes: the torques on the wheels that driver, differentials, brakes and rolling cause.
#pragma once

#include <array>
#include <cstddef>

#include "sil/world/vehicle/driver_input.hpp"
#include "sil/world/vehicle/number.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// Remaining share of the drive of an axle with two spinning wheels: all of it while the slower one is up to 2
// m/s and a fifth faster than the vehicle, nothing at twice that. No driver, engine or traction control lets
// it run away; and wheels that did would tilt the turning vehicle as gyroscopes.
template <typename Real>
Real traction_share(Real rim_speed_mps, Real speed_mps) {
    const Real allowed = 2.0 + 0.2 * number::abs(speed_mps);
    return number::clamp(2.0 - (rim_speed_mps - number::abs(speed_mps)) / allowed, 0.0, 1.0);
}

// Drive torque of each wheel. Each axle has a differential that resists a difference of speeds, so that a
// lifted wheel does not run away with all the power. `speed_mps`: forward.
template <typename Real>
std::array<Real, wheel_count> drive_torques_nm(const BasicDrivelineParameters<Real>& parameters,
                                               Real drive_force_n, Real wheel_radius_m, Real speed_mps,
                                               const std::array<Real, wheel_count>& spin_radps) {
    const Real limit = parameters.drive_force_limit_n;
    const Real half_torque = 0.5 * number::clamp(drive_force_n, -limit, limit) * wheel_radius_m;
    const auto share = [&](std::size_t left, std::size_t right) {
        const Real rim_mps = wheel_radius_m * number::min(spin_radps[left], spin_radps[right]);
        return number::choose(half_torque > 0.0, traction_share(rim_mps, speed_mps), 1.0);
    };
    const Real to_front = half_torque * parameters.front_drive_share;
    const Real front = to_front * share(front_left, front_right);
    const Real rear = (half_torque - to_front) * share(rear_left, rear_right);
    const Real front_lock =
        0.5 * parameters.differential_damping_nmsprad * (spin_radps[front_left] - spin_radps[front_right]);
    const Real rear_lock =
        0.5 * parameters.differential_damping_nmsprad * (spin_radps[rear_left] - spin_radps[rear_right]);
    return {front - front_lock, front + front_lock, rear - rear_lock, rear + rear_lock};
}

// Torque of dry friction (brake, rolling resistance): opposes rotation, and holds the wheel at rest rather
// than turning it backwards. `free_torque_nm`: all other torques.
template <typename Real>
Real friction_torque_nm(Real largest_nm, Real spin_radps, Real free_torque_nm, Real inertia_kgm2,
                        double step_s) {
    const Real stopping = -(inertia_kgm2 * spin_radps / step_s + free_torque_nm);
    return number::clamp(stopping, -largest_nm, largest_nm);
}

}  // namespace sil
