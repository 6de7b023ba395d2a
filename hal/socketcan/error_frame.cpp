// Error frames in the layout of linux/can/error.h: classes in the identifier, controller problems in byte 1.
#include "hal/socketcan/error_frame.hpp"

#include <linux/can/error.h>

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

}  // namespace rsi::hal
