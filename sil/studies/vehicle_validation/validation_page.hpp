// Validation page: a calibration beside the drives of its vehicle, as a table and as a page to look into.
#pragma once

#include <string>
#include <vector>

#include "sil/studies/drives/replay_table.hpp"
#include "sil/studies/vehicle_validation/drive_comparison.hpp"

namespace sil {

struct Validation {
    std::string vehicle{};                // its name
    std::string calibration{};            // where it is from, in words
    std::vector<std::string> warnings{};  // of the identification
    std::vector<DriveComparison> comparisons{};
    std::vector<ReplayRow> replays{};  // of the same drives
};

// drive, comparison, roll_angle_within_share, roll_angle_rms_deg, load_transfer_within_share,
// load_transfer_rms, largest_force_mps2, turn_s, replay, warning_time_s, unavailable_duration_s,
// confirmed_codes, warnings, reason. An unknown value is empty.
std::string validation_csv(const Validation& validation);

// The same for people, with the number of drives of each verdict.
std::string validation_text(const Validation& validation);

// report.html.
std::string validation_page(const Validation& validation);

}  // namespace sil
