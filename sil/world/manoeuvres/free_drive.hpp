// Free drive: a person at a screen steers and chooses the speed while the vehicle drives.
#pragma once

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// The driver's present demand. Hands and feet never move faster than a person's.
struct DriverWish {
    double steering_wheel_angle_rad{0.0};  // > 0 turns left
    double speed_mps{0.0};

    static constexpr double largest_angle_rad = from_degrees(360.0);
    static constexpr double lowest_speed_mps = from_kmh(10.0);
    static constexpr double highest_speed_mps = from_kmh(160.0);
};

inline constexpr double fastest_hands_radps = from_degrees(800.0);  // as in an emergency
inline constexpr double longest_free_drive_s = 3600.0;

// On a level road, from `start_speed_mps` on, for an hour at most. `wish` must outlive whatever drives it; it
// may change at any time between two steps. Beyond its limits it is bounded; not a number counts as the value
// before.
Manoeuvre free_drive(const DriverWish& wish, double start_speed_mps);

}  // namespace sil
