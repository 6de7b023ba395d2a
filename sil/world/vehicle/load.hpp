// Load: the same vehicle with something heavy in or on it, or with tyres that hold better or worse.
#pragma once

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Adds a point mass (below 0 takes away) to the body, above its CG in the plan view, so that the CG moves
// only up or down. `height_m`: of the load above the road. Sprung mass, CG height, roll and pitch inertia and
// all that is measured from the CG (hull, IMU) stay consistent; springs are preloaded so that the vehicle
// stands level, as everywhere in this model. The nominal roll model keeps its values: the firmware does not
// know the load. Throws std::invalid_argument if no mass or no inertia would be left.
VehicleParameters with_load(VehicleParameters parameters, double added_mass_kg, double height_m);

// Multiplies the friction of all tyres by `factor`, above 0; their stiffness stays.
VehicleParameters with_friction(VehicleParameters parameters, double factor);

}  // namespace sil
