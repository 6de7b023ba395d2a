// Turned housings: the usual sensors with an IMU that is turned against the body, as by a loose screw or a
// bracket that is bent. Both accelerations and the roll rate are wrong together.
#pragma once

#include <vector>

#include "sil/studies/faults/fault.hpp"
#include "sil/world/sensors/sensor_options.hpp"

namespace sil {

struct TurnedHousing {
    Fault fault{};  // of the inertial signals, with its sign
    SensorOptions options{};
};

// About x by 2, 4 and 6 deg, about z by 2, 6 and 30 deg, either way.
std::vector<TurnedHousing> turned_housings(const SensorOptions& usual);

// Those about x by 4 and 6 deg, and offsets of the lateral acceleration alone by 0.6, 1 and 1.5 m/s^2, either
// way: an accelerometer that seconds of driving do not show to be wrong.
std::vector<TurnedHousing> lasting_offsets(const SensorOptions& usual);

}  // namespace sil
