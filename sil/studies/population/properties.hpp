// Properties: what follows from a vehicle's parameters by the formulas of textbooks, before a drive.
#pragma once

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct VehicleProperties {
    double static_stability_factor{};  // of the whole vehicle
    double cg_height_m{};              // of the whole vehicle
    double roll_centre_height_m{};     // of the suspension, below the CG
    double roll_arm_m{};               // from there to the sprung CG
    double roll_stiffness_nmprad{};    // of the suspension, its stops out of reach
    double roll_gradient_degpg{};      // of the body on its suspension; in front, where the frame twists
    double roll_frequency_hz{};        // likewise
    double roll_damping_ratio{};
    double
        threshold_g{};  // lateral acceleration that lifts the inner wheels in a slow turn, stops out of reach
    double understeer_gradient_s2pm{};
    double grip{};  // friction with all the load on two wheels
};

VehicleProperties properties(const VehicleParameters& vehicle);

// The handwheel angle that a slow turn of `acceleration_mps2` takes at `speed_mps`, from wheelbase and
// understeer.
double handwheel_for_rad(const VehicleParameters& vehicle, double acceleration_mps2, double speed_mps);

}  // namespace sil
