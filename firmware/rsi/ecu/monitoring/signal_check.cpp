#include "rsi/ecu/monitoring/signal_check.hpp"

namespace rsi::monitoring {

float SignalCheck::qualify(float value, DiagnosticMemory& memory, float expected_change,
                           float road_shake) noexcept {
    const bool valid = rsi::is_within(value, limits_.minimum, limits_.maximum);
    if (!rsi::is_finite(value)) {
        memory.report(limits_.invalid, true);
        forget();
        return rsi::not_available;
    }
    const bool unsteady = (known_ && has_jumped(value, expected_change)) || is_shaken(value, road_shake);
    if (valid && !unsteady && memory.no_active_codes()) {
        keep(value);
        return value;
    }
    memory.report(limits_.invalid, !valid);
    if (valid) {
        memory.report(limits_.jumps, unsteady);
    }
    if (memory.confirmed(limits_.invalid) || memory.confirmed(limits_.jumps)) {
        // From now on each value is compared with the one before: smooth again is good again.
        good_ = value;
        known_ = valid;
        return rsi::not_available;
    }
    if (valid && !unsteady) {
        keep(value);
    }
    return known_ ? good_ : rsi::not_available;
}

// The second difference of white noise is 2.4 times as large as the noise, that of a vehicle's motion next to
// nothing.
bool SignalCheck::is_shaken(float value, float road_shake) noexcept {
    // Bounded, so that a single value that is off, which bends three times, does not come to it.
    const float bend = rsi::smaller(rsi::absolute(value - 2.0F * last_ + before_), 3.5F * limits_.shake);
    const float grown = shake_ + 0.1F * (bend - shake_);
    shake_ = (values_ >= 2U) ? grown : 0.0F;
    values_ = (values_ < 2U) ? values_ + 1U : 2U;
    before_ = last_;
    last_ = value;
    return !rsi::is_within_magnitude(shake_, limits_.shake + road_shake);
}

}  // namespace rsi::monitoring
