// Error frames: what the kernel's report about the controller means for the bus's state.
#pragma once

#include <linux/can.h>

#include "rsi/hal/can_bus.hpp"

namespace rsi::hal {

// State after an error frame that arrives in state `before`. A report that says nothing about fault
// confinement (a lost arbitration, a single bus error) leaves the state as it is.
BusState state_after_error(const canfd_frame& error_frame, BusState before) noexcept;

// Whether the controller says that it had to drop a received frame.
bool tells_of_lost_frame(const canfd_frame& error_frame) noexcept;

}  // namespace rsi::hal
