// Handwheel angle: the angle of 0.3 g from which FMVSS 126 and NHTSA's rollover tests scale their steering.
#pragma once

#include "sil/studies/procedures/procedure.hpp"

namespace sil {

// The mean of slowly increasing steers to both sides (sil/world/manoeuvres/slowly_increasing_steer.hpp). The
// rule books drive three to each side; the simulated ones are all alike. Throws std::runtime_error if the
// vehicle does not reach the acceleration.
double handwheel_angle_of_both_sides_rad(const VehicleParameters& vehicle);

// For the account.
Figure handwheel_figure(double angle_rad);

}  // namespace sil
