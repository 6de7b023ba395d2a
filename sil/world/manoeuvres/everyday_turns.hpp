// Everyday turns: no hard driving, but long enough and slow enough for a faulty sensor to show.
#pragma once

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// Turns of about 0.2 g at 50 mph on a level road, one to each side in turn, straight ahead between them. One
// lasts gentle_turn_s with the straight after it.
inline constexpr double gentle_turn_s = 8.0;
Manoeuvre gentle_turns(double duration_s);

// As on a car park: 12 km/h, and far to one side and the other.
Manoeuvre slow_turns(double duration_s);

}  // namespace sil
