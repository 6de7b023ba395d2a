// AUTOSAR end-to-end protection, profile 11 with the data identifier's nibble (E2E_P11DATAID_NIBBLE), for
// classic CAN.
//
// Byte 0 is the CRC, the low nibble of byte 1 the counter (0 to 14), the high nibble of byte 1 bits 8 to 11
// of the data identifier. The CRC covers the identifier's low byte, a zero byte, and the payload from byte 1
// on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/can_dbc/e2e/channel.hpp"
#include "rsi/can_dbc/e2e/check_status.hpp"
#include "rsi/can_dbc/e2e/crc.hpp"

namespace rsi::can_dbc::e2e {

inline constexpr std::size_t profile_11_header_length = 2U;
inline constexpr std::uint8_t profile_11_largest_counter = 14U;

namespace detail {

// CRC of the identifier's low byte and the zero byte, which precede the payload.
constexpr std::uint8_t profile_11_start(std::uint16_t data_id) {
    const auto after_identifier = Crc8SaeJ1850::update(0U, static_cast<std::uint8_t>(data_id & 0xFFU));
    return Crc8SaeJ1850::update(after_identifier, std::uint8_t{0U});
}

constexpr std::uint8_t profile_11_nibble(std::uint16_t data_id) {
    return static_cast<std::uint8_t>((static_cast<std::uint32_t>(data_id) >> 8U) & 0x0FU);
}

}  // namespace detail

// Writes identifier nibble, counter and CRC into a payload that holds its signals already.
// `data_id` is 0 to 0xFFF, `counter` 0 to 14.
template <std::size_t size>
constexpr void protect_profile_11(std::array<std::uint8_t, size>& payload, std::uint16_t data_id,
                                  std::uint8_t counter) {
    static_assert(size >= profile_11_header_length, "profile 11 needs two bytes of the payload");
    const unsigned nibble = detail::profile_11_nibble(data_id);
    payload[1] = static_cast<std::uint8_t>((nibble << 4U) | (counter & 0x0FU));
    payload[0] = Crc8SaeJ1850::update_from<1U>(detail::profile_11_start(data_id), payload);
}

// The counter of a payload of at least profile_11_header_length bytes; 15 is one that no sender may use.
constexpr std::uint8_t profile_11_counter(const std::uint8_t* payload) {
    return static_cast<std::uint8_t>(payload[1] & 0x0FU);
}

// Errors of a received payload of `length` bytes by itself: everything but the sequence.
constexpr CheckError verify_profile_11(const std::uint8_t* payload, std::size_t length,
                                       std::size_t expected_length, std::uint16_t data_id) {
    if (length != expected_length || length < profile_11_header_length) {
        return CheckError::length;
    }
    if (payload[0] != Crc8SaeJ1850::update(detail::profile_11_start(data_id), payload + 1, length - 1U)) {
        return CheckError::crc;
    }
    if ((payload[1] >> 4U) != detail::profile_11_nibble(data_id)) {
        return CheckError::data_id;
    }
    return profile_11_counter(payload) > profile_11_largest_counter ? CheckError::counter : CheckError::none;
}

struct Profile11 {
    static constexpr unsigned counter_range = profile_11_largest_counter + 1U;

    template <std::size_t size>
    static constexpr void protect(std::array<std::uint8_t, size>& payload, std::uint16_t data_id,
                                  std::uint8_t counter) {
        protect_profile_11(payload, data_id, counter);
    }
    static constexpr CheckError verify(const std::uint8_t* payload, std::size_t length,
                                       std::size_t expected_length, std::uint16_t data_id) {
        return verify_profile_11(payload, length, expected_length, data_id);
    }
    static constexpr std::uint8_t counter(const std::uint8_t* payload) { return profile_11_counter(payload); }
};

using Profile11Sender = Sender<Profile11>;
using Profile11Receiver = Receiver<Profile11>;

}  // namespace rsi::can_dbc::e2e
