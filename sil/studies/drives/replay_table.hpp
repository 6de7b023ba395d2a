// Replay table: many drives in one table, as CSV and for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sil/studies/drives/drive_replay.hpp"

namespace sil {

struct ReplayRow {
    std::string file;
    std::string drive;
    std::optional<double> warning_s;
    std::optional<double> one_wheel_lift_s;
    std::optional<double> two_wheel_lift_s;
    std::optional<double> lead_s;         // of a warning of the falling side
    std::optional<double> wrong_side_s;   // time on the wrong side
    std::optional<double> unavailable_s;  // beyond the start-up
    std::string confirmed_codes;          // at any time
    bool wrong_roll_reference{false};     // one of them
    double largest_load_transfer_ratio{EcuOutput::not_available};
    double largest_warning_level{EcuOutput::not_available};
    std::string verdict;   // see verdict.hpp; "failed" for a file that could not be replayed
    std::string warnings;  // "right at 1.840 s; left at 3.200 s"; empty when there were none
};

ReplayRow replay_row(const std::string& file, const std::string& drive, const DriveReplay& replay);
ReplayRow failed_row(const std::string& file, const std::string& drive);

// Side and time of each warning, as in ReplayRow; of the first ones, with the number of the others.
std::string all_warnings(const DriveReplay& replay);
std::string first_warnings(const std::string& all);

// file, drive, warning_time_s, one_wheel_lift_time_s, two_wheel_lift_time_s, lead_time_s,
// wrong_side_duration_s, unavailable_duration_s, largest_load_transfer_ratio, largest_warning_level, verdict,
// confirmed_codes, warnings. A value that is unknown, or of a missing event, is empty.
std::string table_csv(const std::vector<ReplayRow>& rows);

// The same in columns of even width, a line that counts the verdicts, and what the calibration has wrong.
std::string table_text(const std::vector<ReplayRow>& rows);

}  // namespace sil
