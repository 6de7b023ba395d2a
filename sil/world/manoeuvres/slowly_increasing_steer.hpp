// Slowly increasing steer: how much handwheel this vehicle needs for a given lateral acceleration.
#pragma once

#include <vector>

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Handwheel angle that gives 0.3 g at 50 mph, from a run of the manoeuvre `slowly-increasing-steer` of this
// vehicle on a level road, to the left or, mirrored, to the right; after NHTSA the line fitted from 0.1 to
// 0.375 g, read at 0.3 g. A vehicle that slides between 0.3 and 0.375 g gets the angle at which it first
// reaches 0.3 g. A magnitude. Takes some 5 simulated seconds. Throws std::runtime_error if the vehicle does
// not reach 0.3 g.
double handwheel_angle_at_0_3_g_rad(const VehicleParameters& parameters, bool mirrored = false);

// Finds the angles to the left of several vehicles together, which takes much less time: this thread's
// next calls for them return at once, until the next call of this. A vehicle that does not reach 0.3 g is
// left to them.
void find_handwheel_angles_ahead(const std::vector<const VehicleParameters*>& vehicles);

}  // namespace sil
