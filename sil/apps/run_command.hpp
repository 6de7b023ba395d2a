// Run command: one manoeuvre on a CAN interface, from request to results.
#pragma once

#include <filesystem>
#include <string>

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
};

// Drives the manoeuvre, prints the account and writes signals.csv, events.gp, summary.json and, in lock-step,
// candump.log into the output folder. Throws std::exception with a message for the user.
void run_manoeuvre(const RunRequest& request);

}  // namespace sil
