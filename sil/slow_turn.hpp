// Slow turn: what lifts the inner wheels of a body that leans, by the printed threshold (23).
#pragma once

#include <cmath>

#include "sil/units.hpp"

namespace sil {

struct RollLengths {
    double track_width_m;  // c_w
    double cg_height_m;    // h of the sprung mass
    double arm_m;          // H = h - h_rc

    // From the CG to the outer wheels, across the road.
    double to_outer_wheels_m(double roll_angle_rad) const {
        return 0.5 * track_width_m - arm_m * std::tan(roll_angle_rad);
    }
};

// T(phi): A/N there.
inline double threshold_in_slow_turn(const RollLengths& body, double roll_angle_rad) {
    return body.to_outer_wheels_m(roll_angle_rad) / body.cg_height_m;
}

// The acceleration at which T(phi) is reached.
inline double acceleration_at_threshold_mps2(const RollLengths& body, double roll_angle_rad) {
    return g_mps2 * body.to_outer_wheels_m(roll_angle_rad) / body.cg_height_m;
}

}  // namespace sil
