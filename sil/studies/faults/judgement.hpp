// Judgement: what the ECU did about a fault, measured against the run without it, and what of that was not
// expected.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sil/studies/faults/expectation.hpp"
#include "sil/studies/faults/faulty_run.hpp"

namespace sil {

// Times in milliseconds. A reaction counts from the cycle in which the fault became visible; it is negative
// when it came before.
struct Reaction {
    bool visible{false};
    std::optional<int> unavailable{};
    std::optional<int> observer{};
    std::optional<int> motion_lost{};
    std::optional<int> code{};
    std::string code_name{};         // the first one
    std::optional<int> lead_loss{};  // of a due warning; none: it never came, or none was due
    std::optional<int> lead{};       // before two-wheel lift-off; none: no warning, or no lift-off
    bool warning_missed{false};      // it never came
    bool warning_due{false};
    int silence{0};                 // longest, without code: "ready" while a warning is due
    int wrong{0};                   // longest, without code: another state than without the fault
    int lapse{0};                   // longest, after the first code and while the fault is there, without one
    int false_warning{0};           // in all, where none is due in the whole drive
    std::optional<int> due{};       // after the end of the fault; none: no warning is due, or due before it
    std::optional<int> recovery{};  // none: not until the drive's end, or the drive ends with the fault
    std::optional<int> healing{};   // the same of the codes
    int watched_ms{0};              // from the end of the fault to two-wheel lift-off or the drive's end
    std::size_t incomplete_cycles{0};  // without one of the ECU's frames, or with a damaged one
    std::size_t undefined_cycles{0};   // with a code that the DBC file does not define
    bool watchdog_fed{true};
};

// `right` is the run of the same drive without the fault.
Reaction measure(const FaultedDrive& drive, const Fault& fault, const FaultyRun& right,
                 const FaultyRun& faulty);

// The worst case: a single fault that turns a due warning into "ready", unreported.
bool silences_a_warning(const Reaction& reaction);

// Expected reactions that are missing, each in a few words.
struct Verdict {
    std::vector<std::string> shortfalls{};        // empty: as expected, but for what is
    std::vector<std::string> known_undetected{};  // owed to a known undetected error
};
Verdict judge(const Expectation& expected, const Reaction& reaction);

// "unavailable 30, ImuTimeout 30, back 140": of several reactions the slowest of each, and of how many of
// them it is said where not all of them have it.
std::string describe(const std::vector<Reaction>& reactions);

}  // namespace sil
