// Drive check: what only the whole drive shows to be wrong.
#pragma once

#include "sil/files/csv_reader.hpp"
#include "sil/studies/drives/drive.hpp"
#include "sil/studies/drives/drive_header.hpp"

namespace sil {

// Needs at least two rows, a sampling rate of 50 Hz to 1 kHz (by the median step), roll angle or both speed
// and yaw rate in at least one row, a vertical acceleration that contains gravity, and lift-off times within
// the drive. Throws InputError at the header's line (a lift-off's own).
void check_drive(const Drive& drive, const DriveHeader& header, const CsvPlace& place);

}  // namespace sil
