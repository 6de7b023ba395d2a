// Well-formed frames: what a CAN controller is able to put on the bus (ISO 11898-1).
#pragma once

#include "rsi/hal/can_bus.hpp"

namespace rsi::hal {

inline constexpr std::uint32_t largest_standard_identifier{0x7FFU};
inline constexpr std::uint32_t largest_extended_identifier{0x1FFF'FFFFU};

// A CAN FD length code stands for 0 to 8, 12, 16, 20, 24, 32, 48 or 64 bytes; a classic one for 0 to 8.
constexpr bool is_length_possible(std::uint8_t length, bool flexible_data_rate) noexcept {
    if (length <= 8U) {
        return true;
    }
    if (!flexible_data_rate) {
        return false;
    }
    return length == 12U || length == 16U || length == 20U || length == 24U || length == 32U ||
           length == 48U || length == 64U;
}

constexpr bool is_identifier_possible(std::uint32_t identifier, bool extended) noexcept {
    return identifier <= (extended ? largest_extended_identifier : largest_standard_identifier);
}

// Every bus refuses to send a frame for which this is false (SendResult::failed).
constexpr bool is_well_formed(const CanFrame& frame) noexcept {
    return is_identifier_possible(frame.identifier, frame.extended) &&
           is_length_possible(frame.length, frame.flexible_data_rate);
}

}  // namespace rsi::hal
