// Turn: a manoeuvre whose severity is that of the lateral acceleration which it would give if the vehicle
// were linear.
#pragma once

#include <functional>

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// At 50 mph on a level road; name, description and duration are the caller's. `command`: by the clock, with
// the handwheel angle as a share of the angle for `acceleration_mps2`.
Manoeuvre turn(double acceleration_mps2, std::function<DriverCommand(double)> command);

// A turn to the left from `start_s` on, held; `rate_ps`: share of its handwheel angle that is turned in a
// second.
Manoeuvre held_turn(double acceleration_mps2, double start_s, double rate_ps);

// Swings to one side and the other, one and a half at 0.4 Hz.
Manoeuvre swings(double acceleration_mps2);

}  // namespace sil
