// Replay summary: a replayed drive in one small JSON file.
#pragma once

#include <string>
#include <vector>

#include "sil/studies/drives/drive_replay.hpp"

namespace sil {

struct ReplaySource {
    std::string drive;       // its name
    std::string file;        // that it was read from
    std::string kind;        // "csv" or "candump"
    std::string parameters;  // name of the parameter file, without folder and ending
    std::vector<std::string> ignored_columns;
};

// The keys of a run's summary (sil/results/summary.hpp) in their order, manoeuvre being the drive and
// vehicle the parameter file; what a replay cannot know (mirrored, lock_step, seed, noise, bias_g,
// quantisation_g) is null. Lateral accelerations are measured ones, the roll angle is the sensor's. Then:
//   file, kind, verdict, lift_off_source ("given", "wheel loads", "unknown"), one_wheel_lead_time_s,
//   largest_load_transfer_ratio, largest_warning_level (both before two-wheel lift-off), warning_indicator,
//   start_time_s, end_time_s, cycles, silent_cycles, confirmed_codes (at any time), ignored_columns.
std::string replay_summary_json(const ReplaySource& source, const DriveReplay& replay,
                                const rsi::Parameters& parameters);

}  // namespace sil
