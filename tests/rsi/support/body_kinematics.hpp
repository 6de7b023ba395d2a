// Specific force in a rolled body on a banked road: plane geometry in double, by projection on
// the body's axes.
#pragma once

#include <cmath>

#include "rsi/rsi.h"
#include "tests/rsi/support/nominal.hpp"

namespace rsi_test {

// State of the sprung CG seen from the ground. ISO 8855: the road's left edge up and the body's right side
// down are both positive rotations about the forward axis.
struct GroundMotion {
    double lateral_acceleration_mps2{0.0};   // horizontal, left
    double vertical_acceleration_mps2{0.0};  // up
    double bank_angle_rad{0.0};              // of the road against the horizon
    double roll_angle_rad{0.0};              // of the body against the road
};

struct PlaneVector {
    double left;
    double up;
};

// Component of the specific force (acceleration minus gravity) along axes turned by `angle_rad` about
// forward.
inline PlaneVector specific_force_along(const GroundMotion& motion, double angle_rad) {
    const double left = motion.lateral_acceleration_mps2;
    const double up = gravity_mps2 + motion.vertical_acceleration_mps2;
    return PlaneVector{left * std::cos(angle_rad) + up * std::sin(angle_rad),
                       -left * std::sin(angle_rad) + up * std::cos(angle_rad)};
}

// Readings of the IMU at the CG.
inline rsi_inputs sensed(const GroundMotion& motion) {
    const PlaneVector force = specific_force_along(motion, motion.bank_angle_rad + motion.roll_angle_rad);
    rsi_inputs inputs{};
    inputs.lateral_specific_force_mps2 = static_cast<float>(force.left);
    inputs.vertical_specific_force_mps2 = static_cast<float>(force.up);
    inputs.roll_angle_rad = static_cast<float>(motion.roll_angle_rad);
    inputs.bank_angle_rad = static_cast<float>(motion.bank_angle_rad);
    return inputs;
}

}  // namespace rsi_test
