// Frame translation for classic and CAN FD frames, which share their layout up to the payload's end. Error
// frames are as linux/can/error.h has them: classes in the identifier, controller problems in byte 1.
#include "hal/socketcan/frame_translation.hpp"

#include <linux/can/error.h>

#include <algorithm>
#include <cstring>

namespace rsi::hal {
BusState state_after_error(const canfd_frame& error_frame, BusState before) noexcept {
    constexpr unsigned passive = CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE;
    // The warning level (96 errors) belongs to error-active; ISO 11898-1 makes a node passive at 128.
    constexpr unsigned active = CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING | CAN_ERR_CRTL_ACTIVE;

    const unsigned classes = error_frame.can_id & CAN_ERR_MASK;
    if ((classes & CAN_ERR_BUSOFF) != 0U) {
        return BusState::bus_off;
    }
    if ((classes & CAN_ERR_RESTARTED) != 0U) {
        return BusState::error_active;
    }
    if ((classes & CAN_ERR_CRTL) != 0U && (error_frame.data[1] & passive) != 0U) {
        return BusState::error_passive;
    }
    if ((classes & CAN_ERR_CRTL) != 0U && (error_frame.data[1] & active) != 0U) {
        return BusState::error_active;
    }
    return before;
}

bool tells_of_lost_frame(const canfd_frame& error_frame) noexcept {
    return (error_frame.can_id & CAN_ERR_CRTL) != 0U &&
           (error_frame.data[1] & CAN_ERR_CRTL_RX_OVERFLOW) != 0U;
}

KernelFrameKind kind_of(const canfd_frame& kernel_frame, std::size_t bytes) noexcept {
    if (bytes != CAN_MTU && bytes != CANFD_MTU) {
        return KernelFrameKind::other;
    }
    if ((kernel_frame.can_id & CAN_ERR_FLAG) != 0U) {
        return KernelFrameKind::error;
    }
    return (kernel_frame.can_id & CAN_RTR_FLAG) != 0U ? KernelFrameKind::other : KernelFrameKind::data;
}

CanFrame from_kernel(const canfd_frame& kernel_frame, std::size_t bytes, Time receive_time) noexcept {
    CanFrame frame;
    frame.extended = (kernel_frame.can_id & CAN_EFF_FLAG) != 0U;
    frame.identifier = kernel_frame.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.flexible_data_rate = bytes == CANFD_MTU;
    const unsigned largest = frame.flexible_data_rate ? CANFD_MAX_DLEN : CAN_MAX_DLEN;
    frame.length = static_cast<std::uint8_t>(std::min<unsigned>(kernel_frame.len, largest));
    std::memcpy(frame.data.data(), kernel_frame.data, frame.length);
    frame.receive_time = receive_time;
    return frame;
}

std::size_t to_kernel(const CanFrame& frame, bool bit_rate_switch, canfd_frame& kernel_frame) noexcept {
    kernel_frame = canfd_frame{};
    kernel_frame.can_id = frame.identifier | (frame.extended ? CAN_EFF_FLAG : 0U);
    kernel_frame.len = frame.length;
    if (frame.flexible_data_rate) {
        kernel_frame.flags = static_cast<__u8>(CANFD_FDF | (bit_rate_switch ? CANFD_BRS : 0U));
    }
    std::memcpy(kernel_frame.data, frame.data.data(), frame.length);
    return frame.flexible_data_rate ? CANFD_MTU : CAN_MTU;
}

}  // namespace rsi::hal
