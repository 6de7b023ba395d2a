// Frame translation for classic and CAN FD frames, which share their layout up to the payload's end.
#include "hal/socketcan/frame_translation.hpp"

#include <algorithm>
#include <cstring>

namespace rsi::hal {

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
