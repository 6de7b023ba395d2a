// Procedure: a test of a rule book, run as written, with its verdict and the ECU's warning beside it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/results/ecu_output.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// A number with its unit, for accounts and tables.
struct Figure {
    std::string key{};  // of files: its unit is the last part, as in largest_roll_deg
    std::string name{};
    std::string unit{};
    int decimals{1};
    std::optional<double> value{};  // empty: there is none
};

enum class Bound : std::uint8_t { at_most, below, at_least };

// "at most", "below", "at least".
const char* to_string(Bound bound);

// Requirement of a rule on a step.
struct Criterion {
    Figure measured{};
    Bound bound{Bound::at_most};
    double limit{0.0};
    std::string source{};
    bool asked{true};  // false: measured, but the rule does not ask for it in this step

    // A limit that could not be measured, as after a rollover, is not met.
    bool met() const;
};

// Answer of the ECU during a step.
struct WarningBeside {
    bool lifted{false};  // two wheels of a side, for 50 ms (sil/judge/two_wheel_lift.hpp)
    double lift_off_s{0.0};
    WarningSide falling_side{WarningSide::none};
    WarningState state_at_lift_off{WarningState::unavailable};
    WarningSide side_at_lift_off{WarningSide::none};
    std::optional<double> lead_s{};  // of a warning in force with the falling side; empty: there was none
    std::optional<double> first_advisory_s{};
    std::optional<double> first_warning_s{};
    WarningSide first_warning_side{WarningSide::none};
    double largest_load_transfer_ratio{0.0};  // |LTR| of the true wheel loads
};

struct ProcedureStep {
    std::string series{};  // "left", "right": the direction of the first turn, or the side that is low
    std::string name{};
    std::vector<Figure> figures{};
    std::vector<Criterion> criteria{};
    WarningBeside warning{};

    // Every criterion that is asked.
    bool met() const;
};

enum class ProcedureOutcome : std::uint8_t {
    met,
    not_met,
    measured,  // the rule book sets no limit
};

// "met", "not met", "measured".
const char* to_string(ProcedureOutcome outcome);

struct ProcedureResult {
    std::vector<Figure> before{};  // values that the steps need, such as the handwheel angle of 0.3 g
    std::vector<ProcedureStep> steps{};
    std::vector<Figure> results{};
    ProcedureOutcome outcome{ProcedureOutcome::measured};
    std::string verdict{};             // in words
    std::vector<std::string> notes{};  // where the simulation is not what the rule book has in mind
};

// The outcome of a procedure with limits: every step must meet what is asked of it.
ProcedureOutcome outcome_of(const std::vector<ProcedureStep>& steps);

// The driven step and its listeners.
struct ProcedureWorld {
    VehicleParameters vehicle{};
    rsi::Parameters calibration{};
    std::filesystem::path signals{};  // folder for the signals of each step; empty: none are left
    std::function<void(const ProcedureStep&)> finished_step{};  // may be empty
};

struct Procedure {
    std::string name{};
    std::string description{};           // one line
    std::vector<std::string> sources{};  // documents with their sections
    ProcedureResult (*run)(const ProcedureWorld& world){nullptr};
};

}  // namespace sil
