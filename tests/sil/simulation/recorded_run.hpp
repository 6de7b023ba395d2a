// Recorded run: one closed-loop run in this process and everything that it put on the bus.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/files/candump_log.hpp"
#include "sil/results/ecu_output.hpp"
#include "sil/results/events.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace testing_simulation {

struct RecordedRun {
    std::string log_text;                     // the candump log, byte for byte
    std::vector<sil::LoggedFrame> log;        // the same, read back
    std::vector<sil::EcuOutput> ecu_outputs;  // after each cycle
    sil::RunEvents events;
    std::uint64_t frames_refused{0U};
};

struct RunSettings {
    double duration_s{5.0};
    bool mirrored{false};
    bool noise{false};
    std::uint64_t seed{1U};
};

// A turn that is hard enough for a warning, whether or not the vehicle then rolls over: 80 km/h and 300
// degrees at the handwheel.
sil::Manoeuvre hard_turn();

rsi::Parameters large_suv_calibration();

RecordedRun run_and_record(const sil::Manoeuvre& manoeuvre, const RunSettings& settings = {});

// The frames of the ECU alone, without their times.
std::vector<std::string> ecu_payloads(const std::vector<sil::LoggedFrame>& log);

}  // namespace testing_simulation
