// Recorded drive: one run of a simulated vehicle with the firmware in this process, and the files that it
// leaves.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/results/ecu_output.hpp"
#include "sil/results/events.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace testing_drives {

struct RecordedDrive {
    std::vector<sil::EcuOutput> ecu_outputs;  // after each cycle
    sil::RunEvents events;
};

rsi::Parameters large_suv_calibration();

// The J-turn at 110 km/h, steering from 1 s on: warns, and two wheels lift.
sil::Manoeuvre hard_turn();

// The large SUV, unless otherwise said with noisy sensors; writes signals.csv and candump.log as `sil/run`
// does into `folder`.
RecordedDrive record_drive(const sil::Manoeuvre& manoeuvre, double duration_s,
                           const std::filesystem::path& folder, bool noise = true);

// A change of the warning: "0.31 warning right".
std::vector<std::string> changes(const std::vector<sil::EcuOutput>& outputs);

}  // namespace testing_drives
