// Expectation: what the ECU must do about a fault in a scene, and how fast.
#pragma once

#include <cstdint>
#include <string>

#include "sil/studies/faults/contradiction.hpp"
#include "sil/studies/faults/fault.hpp"
#include "sil/studies/faults/scene.hpp"

namespace sil {

enum class Demand : std::uint8_t {
    recovery,          // any that the rules for every cell allow; what counts is what follows the fault
    unaffected,        // the state is that of the drive without the fault, for all but `wrong_ms`
    right,             // the same, or there is a code
    reported,          // a diagnostic code; the state may be any that the rules for every cell allow
    usable,            // a code, and the state is never "unavailable"
    roll_sensor_lost,  // a code, the observer's roll angle in use, never "unavailable"
    motion_lost,       // a code, the degradation of that name, never "unavailable"
    unavailable,       // a code and "unavailable"
};

const char* to_string(Demand demand);

struct Expectation {
    Demand demand{};
    int reaction_ms{0};   // at the latest after the fault has become visible
    int recovery_ms{0};   // at the latest after it is over: the statement is that of the drive without it
    int healing_ms{0};    // at the latest after it is over: no code is left
    int wrong_ms{0};      // a state other than without the fault, without a code, lasts no longer
    int lead_loss_ms{0};  // a warning that is due and that the state can tell is no later
    int lapse_ms{0};      // after the first code and while the fault is there, no longer without one
    // No check detects the error before the warning is due: its effect on the warning is reported as a limit
    // of the component, and is no shortfall.
    bool known_undetected{false};
};

Expectation expectation_of(const Fault& fault, SceneKind scene);

// For every cell, whatever the fault:
// a warning that is due is never "ready" without a code, not for one cycle,
inline constexpr int longest_silence_ms = 0;
// in states that can show it, and if the fault shows at once or need not show, it comes no later than this,
inline constexpr int longest_lead_loss_ms = 100;
// and always so long before two wheels lift: a driver who has less cannot act,
inline constexpr int least_lead_ms = 100;
// a warning without a reason may stand so long: the reaction, and the time for which a warning is held.
int longest_false_warning_ms(const Expectation& expectation);

}  // namespace sil
