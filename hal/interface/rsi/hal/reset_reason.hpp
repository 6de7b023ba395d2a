// Reset reason: why the controller started, as far as a platform knows.
#pragma once

#include <cstdint>

namespace rsi::hal {

// Sent with these numbers (RollObserver.ResetReason).
enum class ResetReason : std::uint8_t {
    power_on = 0,  // or nothing is known
    outside = 1,   // the firmware was running and recorded nothing: watchdog, or an external reset
    undefined_instruction = 2,
    supervisor_call = 3,
    prefetch_abort = 4,
    data_abort = 5,
    stack_overflow = 6,
    interrupt = 7,            // an unexpected one
    start_without_reset = 8,  // the firmware was entered at its start while it ran: a call of a null pointer
};

}  // namespace rsi::hal
