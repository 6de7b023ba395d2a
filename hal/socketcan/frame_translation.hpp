// Frame translation: between hal::CanFrame and the kernel's frame structures.
#pragma once

#include <linux/can.h>

#include <cstddef>

#include "rsi/hal/can_bus.hpp"

namespace rsi::hal {

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
