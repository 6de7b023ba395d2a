// Roll-centre comparison: what makes a vehicle the paper's "model with the fixed roll centre", part by part.
#pragma once

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Front and rear roll centres fixed in the body, at the height that they have at rest.
VehicleParameters with_fixed_roll_centre(VehicleParameters parameters);

// No stops, and dampers that resist bump and rebound alike.
VehicleParameters with_linear_suspension(VehicleParameters parameters);

}  // namespace sil
