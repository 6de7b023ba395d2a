// Expectation: what the ECU must do about a fault, and how fast.
#pragma once

#include <cstdint>
#include <string>

#include "sil/faults/fault.hpp"

namespace sil {

enum class Demand : std::uint8_t {
    unaffected,         // the state is that of the drive without the fault
    right_or_reported,  // the statement is right, or there is a code
    kept_or_reported,   // a warning that is due comes in time, or there is a code
    reported,           // a diagnostic code; the state may be any that the rules for every cell allow
    usable,             // a code, and the state is never "unavailable"
    roll_sensor_lost,   // a code, the observer's roll angle in use, never "unavailable"
    motion_lost,        // a code, the degradation of that name, never "unavailable"
    unavailable,        // a code and "unavailable"
};

const char* to_string(Demand demand);

struct Expectation {
    Demand demand{};
    int reaction_ms{0};  // at the latest after the fault has become visible
    int recovery_ms{0};  // at the latest after it is over: the statement is that of the drive without it
    int healing_ms{0};   // at the latest after it is over: no code is left
};

Expectation expectation_of(const Fault& fault);

// Where the statement must be right, it may be another one for so long.
inline constexpr int longest_wrong_ms = 100;
// For every cell, whatever the fault:
// a warning that is due may be missing without a code or "unavailable" for so long,
inline constexpr int longest_silence_ms = 50;
// a warning whose state is not "unavailable" may be late by so much,
inline constexpr int largest_lead_loss_ms = 100;
// a warning without a reason may stand so long: the reaction, and the time for which a warning is held.
int longest_false_warning_ms(const Expectation& expectation);

}  // namespace sil
