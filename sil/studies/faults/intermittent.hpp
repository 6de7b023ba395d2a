// Intermittent faults: bursts of an error in one signal, once or again and again, on roads where no warning
// is due.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/studies/faults/fault.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct IntermittentVehicle {
    std::string name{};
    VehicleParameters vehicle{};
    rsi::Parameters calibration{};
};

// A drive of 70 s.
struct IntermittentRun {
    std::string vehicle{};
    std::string drive{};
    Fault fault{};
    int burst_ms{0};
    int period_ms{0};         // 0: a single burst
    int false_warning_ms{0};  // in all: the ECU without the fault does not warn
    int without_code_ms{0};   // of that, before the first code
    std::optional<int>
        code_ms{};  // the first one, from the beginning of the third burst on; 0 if it came before
};

inline constexpr int longest_unreported_ms = 300;

// Every burst of every signal. `most_runs`: a sample of so many, evenly spread; 0: all.
std::vector<IntermittentRun> run_intermittent_faults(const std::vector<IntermittentVehicle>& vehicles,
                                                     std::size_t most_runs,
                                                     const std::function<void(double share)>& progress);

// A false warning without a code for longer than that, each in a line.
std::vector<std::string> intermittent_shortfalls(const std::vector<IntermittentRun>& runs);

// Their sum as a row of docs/reports/safety/intermittent_faults.md, and the page.
std::string intermittent_row(const std::string& name, const std::vector<IntermittentRun>& runs);
std::string intermittent_document(const std::vector<IntermittentRun>& runs, const std::string& sums);

}  // namespace sil
