// Driving state: where a fault can be long before it matters, and from the ECU's start on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sil/studies/faults/recorded_drive.hpp"

namespace sil {

struct DrivingState : FaultedDrive {
    std::string name{};
    std::string description{};
    std::size_t ordinary_end{
        0U};  // cycle up to which ordinary driving has shown a dead or weak sensor; 0: none
    bool with_frame_faults{true};  // false: too long for faults that show at once everywhere
};

// At rest; below 18 km/h; a J-turn with the fault from power-on; the same after a reset in a turn before it;
// and after a minute of ordinary driving. For each set of sensors; all of them drive the same.
std::vector<std::vector<DrivingState>> record_states(const VehicleParameters& vehicle,
                                                     const std::vector<SensorOptions>& sensors);

// Before and after a memory of minutes can have learnt: the J-turn from power-on, and the same after ten
// minutes of ordinary driving.
std::vector<std::vector<DrivingState>> record_ten_minutes(const VehicleParameters& vehicle,
                                                          const std::vector<SensorOptions>& sensors);

// Further drives in which good sensors must set no code.
std::vector<std::vector<DrivingState>> record_drives_of_good_sensors(
    const VehicleParameters& vehicle, const std::vector<SensorOptions>& sensors);

}  // namespace sil
