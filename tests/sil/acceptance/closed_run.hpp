// Closed run: one manoeuvre of a vehicle with the firmware in the same process, and what came of it.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sil/results/events.hpp"
#include "sil/simulation/closed_loop.hpp"
#include "sil/world/vehicle/road.hpp"

namespace rsi_test {

struct RunSettings {
    std::string manoeuvre;
    std::string vehicle{"large_suv"};
    bool mirrored{false};
    bool noise{false};
    std::uint64_t seed{1U};
    double duration_s{0.0};              // 0: the manoeuvre's own
    std::vector<std::string> changes{};  // of the calibration, "key=value"
    bool attitude_sensor{false};         // the roll angle is one against the horizon
    bool bank_sensor{false};
    sil::MakeRoad road{};                                // none: the manoeuvre's own
    std::function<void(sil::SensorOptions&)> sensors{};  // changes them; none: as they are
};

// The paper's estimator and indicator, warning at its threshold.
inline const std::vector<std::string> as_published{"estimator=published", "warning_indicator=published",
                                                   "warning_on=1.0",      "warning_off=0.9",
                                                   "advisory_on=0.9",     "advisory_off=0.8"};

struct RunResult {
    sil::RunEvents events;
    std::vector<sil::WarningState> states;  // one a cycle
    std::vector<sil::WarningSide> sides;    // one a cycle
    std::vector<sil::Truth> truths;         // one a cycle
    double largest_rsi{0.0};
    std::set<rsi::can_dbc::RolloverDiagnosis::Code> confirmed_codes{};  // at any time

    bool reached(sil::WarningState state) const;
};

RunResult drive(const RunSettings& settings);

}  // namespace rsi_test
