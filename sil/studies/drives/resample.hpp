// Resampling: a drive in the firmware's cycle of 10 ms.
#pragma once

#include <vector>

#include "sil/studies/drives/drive.hpp"

namespace sil {

// Sensor values on the bus in one cycle.
struct DriveCycle {
    bool has_frames{true};  // false within a gap: nothing is sent
    DriveSample sample;     // at the cycle's time; all but the time NaN without frames
};

// Longest distance of two samples that is bridged.
inline constexpr double longest_bridged_gap_s = 0.035;

// Cycles at first time + k * 10 ms up to the last sample. At 100 Hz and below a value is interpolated
// linearly between its neighbours; above, it is the mean of the samples within 10 ms, weighted by a triangle
// (1 at the cycle's time, 0 at 10 ms), which damps what 100 Hz cannot show and delays nothing. Between
// samples further apart than longest_bridged_gap_s there are no frames, unless a sample is within 5 ms: then
// it is taken as it is. A value next to one that is not available is not available. `drive` as from
// read_drive_csv.
std::vector<DriveCycle> to_cycles(const Drive& drive);

}  // namespace sil
