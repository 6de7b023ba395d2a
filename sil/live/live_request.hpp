// Live request: what the page of a live drive asks for.
#pragma once

#include <optional>
#include <string_view>

namespace sil {

struct FaultChoice {
    int place{0};  // of LiveFaults, or -1: all sensors good
    int kind{0};
};

struct LiveRequest {
    std::optional<double> steering_deg{};  // > 0 turns left
    std::optional<double> speed_kmh{};
    std::optional<bool> pause{};
    std::optional<FaultChoice> fault{};
    bool again{false};  // another drive, with the load
    double load_kg{0.0};
};

inline constexpr double heaviest_roof_load_kg = 300.0;

// {"steering_deg": 90}, {"speed_kmh": 80}, {"pause": true}, {"fault": {"place": 0, "kind": 1}}, {"fault":
// null}, {"again": true, "load_kg": 100, "speed_kmh": 80}. Throws InputError with a sentence for whatever
// else it is.
LiveRequest parse_live_request(std::string_view text);

}  // namespace sil
