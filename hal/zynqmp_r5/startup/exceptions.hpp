// Reaction of an image to an exception that has ended its run.
#pragma once

#include "hal/zynqmp_r5/fault_record.hpp"

namespace rsi::hal::zynqmp_r5 {

// The image's record, in memory that no start clears.
FaultRecord& fault_record() noexcept;

// Supplied by the image; called once, on the stack of the exceptions, after the fault has been recorded and
// before the reset. The memory may be damaged, so it uses as little of it as it can, and it is bounded.
void on_fault(const Fault& fault) noexcept;

// Resets the controller.
[[noreturn]] void reset_now() noexcept;

}  // namespace rsi::hal::zynqmp_r5
