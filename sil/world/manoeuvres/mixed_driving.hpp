// Mixed driving: a driver who goes straight, turns, changes lanes and weaves at changing speeds, by chance.
#pragma once

#include <cstdint>

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// For long runs. Level road, 30 to 110 km/h; most turns below 0.5 g, some at the limit or beyond, so that a
// warning is due now and then and the vehicle may roll over. The same seed gives the same drive.
Manoeuvre mixed_driving(std::uint64_t seed, double duration_s);

// The same without hard turns: no more than about 0.4 g times `share_of_acceleration`, and the driver
// corrects what the vehicle does otherwise than wanted. No warning is due.
inline constexpr const char* ordinary_driving_name = "ordinary-driving";
inline constexpr double ordinary_driving_s = 600.0;
Manoeuvre ordinary_driving(std::uint64_t seed, double duration_s = ordinary_driving_s,
                           double share_of_acceleration = 1.0);

}  // namespace sil
