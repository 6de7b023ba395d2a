// Frame translation: between hal::CanFrame and the kernel's frame structures, its time stamps and its error
// frames.
#pragma once

#include <linux/can.h>

#include <cstddef>

#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/clock.hpp"

namespace rsi::hal {

// State after an error frame that arrives in state `before`. A report that says nothing about fault
// confinement (a lost arbitration, a single bus error) leaves the state as it is.
BusState state_after_error(const canfd_frame& error_frame, BusState before) noexcept;

// Whether the controller says that it had to drop a received frame.
bool tells_of_lost_frame(const canfd_frame& error_frame) noexcept;

// The kernel stamps a frame on CLOCK_REALTIME when the driver hands it over. Its age is the wall clock's time
// now minus the stamp; the monotonic receive time is now minus that age. `wall_now` and `monotonic_now` are
// read together. Someone may set the wall clock between stamp and reading; the result therefore stays between
// `earliest` (when the queue was last seen empty) and `monotonic_now`.
constexpr Time monotonic_receive_time(Time wall_stamp, Time wall_now, Time monotonic_now,
                                      Time earliest) noexcept {
    const Time estimate = monotonic_now - (wall_now - wall_stamp);
    if (monotonic_now < estimate) {
        return monotonic_now;
    }
    return estimate < earliest ? earliest : estimate;
}

enum class KernelFrameKind : std::uint8_t { data, error, other };

// Kind of a frame of `bytes` bytes, as read from a raw CAN socket. `other` is a remote frame or nothing we
// know.
KernelFrameKind kind_of(const canfd_frame& kernel_frame, std::size_t bytes) noexcept;

// For frames of kind `data`. A payload length that no frame can have is cut to the largest possible.
CanFrame from_kernel(const canfd_frame& kernel_frame, std::size_t bytes, Time receive_time) noexcept;

// Writes a well-formed frame and returns its size in bytes (CAN_MTU or CANFD_MTU).
// `bit_rate_switch` asks for the faster bit rate in the data phase; it matters to CAN FD frames only.
std::size_t to_kernel(const CanFrame& frame, bool bit_rate_switch, canfd_frame& kernel_frame) noexcept;

}  // namespace rsi::hal
