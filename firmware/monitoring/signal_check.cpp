#include "monitoring/signal_check.hpp"

namespace monitoring {

float SignalCheck::qualify(float value, DiagnosticMemory& memory, float expected_change) noexcept {
    const bool valid = rsi::is_within(value, limits_.minimum, limits_.maximum);
    memory.report(limits_.invalid, !valid);
    if (!rsi::is_finite(value)) {
        known_ = false;
        return rsi::not_available;
    }
    if (valid) {
        memory.report(limits_.jumps, known_ && has_jumped(value, expected_change));
    }
    if (memory.confirmed(limits_.invalid) || memory.confirmed(limits_.jumps)) {
        // From now on each value is compared with the one before: smooth again is good again.
        good_ = value;
        known_ = valid;
        return rsi::not_available;
    }
    if (valid && !(known_ && has_jumped(value, expected_change))) {
        good_ = value;
        known_ = true;
    }
    return known_ ? good_ : rsi::not_available;
}

}  // namespace monitoring
