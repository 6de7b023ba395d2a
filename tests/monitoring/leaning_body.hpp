// Leaning body: the roll angle at which the springs hold a vehicle's body.
#pragma once

#include "rsi/types.hpp"

namespace monitoring_test {

// Against the road, under a lateral specific force at rest; with the linear part of the stiffness.
inline float held_roll_angle_rad(const rsi::Parameters& vehicle, float force_mps2) {
    return force_mps2 * vehicle.sprung_mass_kg *
           (vehicle.sprung_cg_height_m - vehicle.fixed_roll_centre_height_m) / vehicle.roll_stiffness_nmprad;
}

}  // namespace monitoring_test
