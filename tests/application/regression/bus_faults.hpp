// Bus faults: modifies a recording of sensor frames, one kind of fault after the other.
#pragma once

#include <vector>

#include "sil/files/candump_log.hpp"

namespace rsi_test {

// Drops, damages and repeats frames, from the times below on:
//     1.00 s  Imu: one frame missing
//     1.50 s  Imu: missing for 0.1 s
//     2.00 s  RollAngle: one bit of each frame damaged for 0.1 s
//     2.50 s  VehicleMotion: the same frame again and again for 0.1 s
//     3.00 s  Imu and RollAngle: missing for 0.3 s
//     4.00 s  RollAngle: missing from now on
std::vector<sil::LoggedFrame> with_bus_faults(const std::vector<sil::LoggedFrame>& frames);

}  // namespace rsi_test
