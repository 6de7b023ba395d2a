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

}  // namespace sil
