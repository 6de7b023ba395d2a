// Replay CSV: every index over time, and every change of the warning and of the diagnosis, of a replayed
// drive.
#pragma once

#include <string>
#include <vector>

#include "sil/studies/drives/drive_replay.hpp"

namespace sil {

// Names of the columns of indices.csv, in their order; quantity and unit as in signals.csv. "sensor_" is what
// the sensors said, "state", "side", "degradation" and the diagnostic codes what the ECU's frames said,
// "measured_" is of the wheel loads; everything else are the component's outputs under their
// own names.
std::vector<std::string> indices_csv_columns();

// Header and one row a cycle. A value that is not available is an empty field.
std::string indices_csv(const DriveReplay& replay);

// time_s,state,side: the first cycle and every one at which state or side is another than before.
std::string warnings_csv(const DriveReplay& replay);

// time_s,degradation,codes_set,codes_confirmed: the first cycle and every one at which one of them is another
// than before. The codes by their names, with a semicolon between; a confirmed one is set too.
std::string diagnosis_csv(const DriveReplay& replay);

}  // namespace sil
