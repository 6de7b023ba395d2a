// CAN socket: the system calls that open, configure and read a raw CAN socket.
#pragma once

#include <linux/can.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/socketcan/interface_lookup.hpp"
#include "hal/socketcan/open_result.hpp"
#include "rsi/hal/clock.hpp"

namespace rsi::hal {

inline constexpr std::size_t most_receive_filters{64U};

// Everything needed to make the socket again after its interface has vanished.
struct CanSocketSettings {
    InterfaceName interface_name{};
    std::array<can_filter, most_receive_filters> filters{};
    std::size_t filter_count{0U};
    int receive_buffer_bytes{0};
    bool receive_own_frames{false};
};

struct CanSocketResult {
    OpenFailure failure{OpenFailure::none};
    int system_error{0};
    int descriptor{-1};  // open, bound and non-blocking when failure is none
};

CanSocketResult open_can_socket(const CanSocketSettings& settings) noexcept;

struct ReadResult {
    int system_error{0};  // EAGAIN when nothing waits
    std::size_t bytes{0U};
    bool has_wall_stamp{false};
    Time wall_stamp{};  // CLOCK_REALTIME at the driver's hand-over
    bool has_drop_count{false};
    std::uint32_t drop_count{0U};  // frames the socket has dropped since it was made, modulo 2^32
};

// Reads one frame with its ancillary data; never blocks.
ReadResult read_frame(int descriptor, canfd_frame& kernel_frame) noexcept;

}  // namespace rsi::hal
