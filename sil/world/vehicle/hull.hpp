// Hull: the bodywork's corners on the road once the vehicle has tipped over; keeps it from falling through.
#pragma once

#include "sil/world/vehicle/equations_of_motion.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/road.hpp"
#include "sil/world/vehicle/state.hpp"

namespace sil {

// Adds the forces of all corners that are below the road. `rotation`: body axes to earth-fixed.
void add_hull_contact(const HullParameters& hull, const State& state, const Matrix3& rotation,
                      const Road& road, EquationsOfMotion& equations);

}  // namespace sil
