// Live faults: what can go wrong with each sensor of a live drive, by place and kind as the page lists them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sil/live/live_request.hpp"
#include "sil/studies/faults/fault.hpp"

namespace sil {

struct LiveFaults {
    FaultPlace place{};
    std::vector<Fault> kinds{};
};

// Those of the fault matrix that are of a signal, in its order.
const std::vector<LiveFaults>& live_faults();

// None for the choice that all sensors are good. Throws InputError for one that is not in the list.
std::optional<Fault> chosen_fault(const FaultChoice& choice);

// "roll angle: frozen"; empty without a fault.
std::string fault_text(const std::optional<Fault>& fault);

// For the page: [{"place": "...", "kinds": ["...", ...]}, ...].
std::string live_faults_json();

}  // namespace sil
