// Live request: what the page of a live drive asks for, and the faults that it can choose.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sil/studies/faults/fault.hpp"

namespace sil {

struct FaultChoice {
    int place{0};  // of LiveFaults, or -1: all sensors good
    int kind{0};
};

struct LiveRequest {
    std::optional<double> steering_deg{};  // > 0 turns left
    std::optional<double> speed_kmh{};
    std::optional<bool> pause{};
    std::optional<bool> brake_on_warning{};
    std::optional<FaultChoice> fault{};
    bool again{false};  // another drive, with the load
    double load_kg{0.0};
};

inline constexpr double heaviest_roof_load_kg = 300.0;

// {"steering_deg": 90}, {"speed_kmh": 80}, {"pause": true}, {"brake_on_warning": true},
// {"fault": {"place": 0, "kind": 1}}, {"fault":
// null}, {"again": true, "load_kg": 100, "speed_kmh": 80}. Throws InputError with a sentence for whatever
// else it is.
LiveRequest parse_live_request(std::string_view text);

struct LiveFaults {
    FaultPlace place{};
    std::vector<Fault> kinds{};
};

// Those of the fault matrix that change a sample, in its order.
const std::vector<LiveFaults>& live_faults();

// None for the choice that all sensors are good. Throws InputError for one that is not in the list.
std::optional<Fault> chosen_fault(const FaultChoice& choice);

// "roll angle: frozen"; empty without a fault.
std::string fault_text(const std::optional<Fault>& fault);

// For the page: [{"place": "...", "kinds": ["...", ...]}, ...].
std::string live_faults_json();

}  // namespace sil
