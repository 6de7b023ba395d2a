// Finding: what an ECU must not do about a fault wherever it is, or about good sensors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sil/studies/faults/fault.hpp"
#include "sil/studies/faults/faulty_run.hpp"

namespace sil {

enum class FindingKind : std::uint8_t {
    missed_warning,  // due before two wheels lift; there is none in force, and no code says why
    false_warning,   // for long and without a code, where none is due and the wheels carry as they should
    not_found,       // a dead or weak accelerometer, in a minute of ordinary driving
    second_sender_accepted,  // its frames are used, or the ECU's own identifier is taken, and nothing says so
    good_sensor_with_code,   // a code, or "unavailable", without a fault
};

const char* to_string(FindingKind kind);

// A warning must be in force least_lead_ms before two wheels lift, or longest_lead_loss_ms after it is due if
// that is later. A false one may last so long,
inline constexpr int longest_false_warning_without_code_ms = 500;
// and is not false at all so long before or after a due one for the same side, or after or before the wheels
// of that side truly carry so much more: a warning there is no nuisance.
inline constexpr int warning_nearby_ms = 2000;
inline constexpr double large_load_transfer = 0.7;
// A second sender must show in the ECU's state after so long.
inline constexpr int second_sender_shows_ms = 200;
// For so long after the start "unavailable" indicates no fault: without a roll sensor the observer settles
// first.
inline constexpr int start_ms = 300;

// Judged against the run of the same drive without the fault, until two wheels lift: a missed and a false
// warning, whatever the fault.
std::vector<FindingKind> silent_findings(const FaultedDrive& drive, const FaultyRun& right,
                                         const FaultyRun& faulty);

// Those, and of a second sender that it is accepted; of a dead or weak lateral accelerometer that no code
// comes before the cycle `ordinary_end` (0: no such demand).
std::vector<FindingKind> findings_of(const FaultedDrive& drive, const Fault& fault, const FaultyRun& right,
                                     const FaultyRun& faulty, std::size_t ordinary_end);

// Finding for sensors without a fault; `right` is the run with the usual ones.
std::vector<FindingKind> findings_of_good_sensors(const FaultedDrive& drive, const FaultyRun& right,
                                                  const FaultyRun& other);

}  // namespace sil
