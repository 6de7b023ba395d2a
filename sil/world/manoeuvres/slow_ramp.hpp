// Slow ramp steer to either side.
#pragma once

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// The driver turns back where the true load transfer ratio reaches `back_from_ltr`, or at 150 degrees.
Manoeuvre slow_ramp(double back_from_ltr = 0.8);

}  // namespace sil
