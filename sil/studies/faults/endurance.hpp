// Endurance: hours of mixed driving with random faults, one after the other, on one ECU that is never started
// anew.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct EnduranceSettings {
    double hours{24.0};
    std::uint64_t seed{1U};
};

// Compared cycle by cycle with a second ECU that gets the same drive without faults.
struct EnduranceResult {
    std::uint64_t cycles{0U};
    std::uint64_t faults{0U};
    std::uint64_t pairs{0U};                    // of these: two that overlap or follow each other closely
    std::uint64_t stops{0U};                    // of the vehicle
    std::uint64_t over_at_standstill{0U};       // faults
    std::uint64_t recovered_at_standstill{0U};  // of these: before the vehicle moved again
    std::uint64_t rollovers{0U};                // after each the drive goes on with a new vehicle
    std::uint64_t warnings_due{0U};             // how often the second ECU came to warn
    std::uint64_t due_with_fault{0U};           // of these: while a fault was there, or within 2 s after it
    std::uint64_t due_with_fault_warned{0U};    // of those: the first ECU warned as well
    std::uint64_t due_with_fault_reported{0U};  // or was `unavailable`, or sent a code
    std::uint64_t due_with_fault_silenced{0U};  // or was `ready` without a code, if only for a cycle
    std::vector<std::string> silenced_by{};     // the faults at each silence, with the second of the drive
    // The same where an error that no check detects is among them.
    std::vector<std::string> silenced_known_undetected{};
    int longest_silence_ms{0};                      // the longest such time
    std::uint64_t incomplete_cycles{0U};            // without one of the ECU's frames
    std::uint64_t undefined_cycles{0U};             // with a code that the DBC file does not define
    std::uint64_t bad_outputs{0U};                  // cycles with an output infinite or out of its range
    std::uint64_t unfed_cycles{0U};                 // in which the watchdog was not fed once
    std::vector<std::string> not_recovered_from{};  // not as the second ECU within `recovery_limit_ms`
    int longest_recovery_ms{0};  // of driving, of those from which it came back; a standstill does not count
    double largest_roll_centre_deviation_m{0.0};  // of the estimator, over all
    double largest_roll_centre_movement_m{0.0};   // likewise
};

// Longest time of driving from the end of a fault until the ECU says what it would say without it.
inline constexpr int recovery_limit_ms = 10000;

// `progress` is called with the share that is done, once a simulated hour. Throws std::invalid_argument when
// the calibration is refused.
EnduranceResult run_endurance(const VehicleParameters& vehicle, const rsi::Parameters& calibration,
                              const EnduranceSettings& settings,
                              const std::function<void(double share)>& progress);

// Faults of the result, each in a few words; empty when all is well.
std::vector<std::string> shortfalls(const EnduranceResult& result);

// One row of the table in docs/reports/safety/endurance.md, and the page with these rows.
std::string endurance_document(const std::string& rows);
std::string endurance_row(const EnduranceSettings& settings, const EnduranceResult& result);

}  // namespace sil
