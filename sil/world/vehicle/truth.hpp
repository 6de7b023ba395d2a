// Truth: what the simulated vehicle really does at one instant; sensors and analysis read it, the firmware
// never does.
#pragma once

#include <array>
#include <cstddef>

namespace sil {

enum Wheel : int { front_left = 0, front_right = 1, rear_left = 2, rear_right = 3 };
inline constexpr int wheel_count = 4;

// Signs are ISO 8855: x forward, y left, z up; a left turn has positive yaw rate, lateral acceleration and
// roll. "Body" means the axes of the sprung mass, "at the CG" its centre of gravity.
// `Real` is double, but where several vehicles are computed at once (lanes.hpp).
template <typename Real>
struct BasicTruth {
    Real time_s{0.0};
    Real mass_kg{0.0};  // of the whole vehicle with what it carries

    Real steering_wheel_angle_rad{0.0};  // at the handwheel, > 0 for a left turn
    Real road_wheel_angle_rad{0.0};      // mean of the front wheels

    Real position_x_m{0.0};  // CG in the earth-fixed frame
    Real position_y_m{0.0};
    Real position_z_m{0.0};
    Real yaw_angle_rad{0.0};

    Real speed_mps{0.0};             // along the vehicle's heading, in the road plane
    Real lateral_velocity_mps{0.0};  // left of the heading, in the road plane

    Real roll_angle_rad{0.0};       // body relative to the road
    Real roll_to_horizon_rad{0.0};  // body relative to the horizontal plane
    Real pitch_angle_rad{0.0};      // body relative to the road
    Real bank_angle_rad{0.0};       // road, > 0 when the left side is up, seen along the heading

    std::array<Real, 3> angular_velocity_radps{};       // body components: roll, pitch, yaw rate
    std::array<Real, 3> angular_acceleration_radps2{};  // body components
    std::array<Real, 3>
        specific_force_mps2{};  // body components at the CG; (0, 0, +g) at rest on a level road

    Real lateral_acceleration_mps2{0.0};  // horizontal, at the CG, without gravity: a_y of the paper

    std::array<Real, wheel_count> wheel_load_n{};  // vertical tyre forces, 0 when the wheel has lifted
    std::array<Real, wheel_count> suspension_deflection_m{};  // jounce > 0
    std::array<Real, wheel_count> wheel_gap_m{};  // lowest tyre point above the road, 0 while it touches

    Real lateral_tyre_force_n{0.0};  // sum over the wheels, in the road plane, left > 0
    Real roll_centre_height_m{0.0};  // equation (24); NaN where it is not defined (small force, lifted wheel)
    Real roll_centre_lateral_m{
        0.0};  // kinematic, c_rc > 0 in the direction in which the CG moves for roll > 0; NaN if undefined
    Real roll_centre_kinematic_height_m{0.0};  // of the same point, above the road; NaN if undefined

    std::array<Real, wheel_count> wheel_spin_radps{};  // > 0 when rolling forward
};
using Truth = BasicTruth<double>;

// A wheel that carries nothing has lifted.
inline bool has_lifted(const Truth& truth, Wheel wheel) {
    return truth.wheel_load_n[static_cast<std::size_t>(wheel)] <= 0.0;
}

inline bool left_side_has_lifted(const Truth& truth) {
    return has_lifted(truth, front_left) && has_lifted(truth, rear_left);
}

inline bool right_side_has_lifted(const Truth& truth) {
    return has_lifted(truth, front_right) && has_lifted(truth, rear_right);
}

// The beginning of a rollover.
inline bool two_wheels_have_lifted(const Truth& truth) {
    return left_side_has_lifted(truth) || right_side_has_lifted(truth);
}

}  // namespace sil
