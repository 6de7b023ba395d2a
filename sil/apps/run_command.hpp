// Run command: one manoeuvre on a CAN interface or in this process, from request to results.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sil/simulation/mounted_sensors.hpp"

namespace sil {

struct RunRequest {
    std::string manoeuvre;
    std::string interface{"vcan0"};
    std::string vehicle_file;
    std::filesystem::path output;
    SensorFlaws sensors{};
    double duration_s{0.0};  // 0: the manoeuvre's own
    bool mirrored{false};
    bool lock_step{false};
    bool in_process{false};
    std::string calibration_file{};      // in process only
    std::vector<std::string> changes{};  // of the calibration, as "key=value"
};

// Drives the manoeuvre, prints the account and writes signals.csv, events.gp, report.html and summary.json
// into the output folder, in lock-step candump.log too, and in process also firmware.csv and lifts.csv.
// Throws std::exception with a message for the user.
void run_manoeuvre(const RunRequest& request);

}  // namespace sil
