// AUTOSAR end-to-end protection, profile 5, for CAN FD.
//
// From byte `offset` on: the CRC in two bytes, low byte first, and the counter (0 to 255) in one. The CRC
// covers the whole payload but its own two bytes, and then the data identifier, low byte first, which is not
// sent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "can_dbc/e2e/channel.hpp"
#include "can_dbc/e2e/check_status.hpp"
#include "can_dbc/e2e/crc.hpp"

namespace can_dbc::e2e {

inline constexpr std::size_t profile_05_header_length = 3U;
inline constexpr std::size_t profile_05_crc_length = 2U;
inline constexpr unsigned profile_05_counter_range = 256U;

namespace detail {

// `length` is at least offset + 3.
constexpr std::uint16_t profile_05_crc(const std::uint8_t* payload, std::size_t length, std::size_t offset,
                                       std::uint16_t data_id) {
    const std::array<std::uint8_t, 2> suffix{static_cast<std::uint8_t>(data_id & 0xFFU),
                                             static_cast<std::uint8_t>(data_id >> 8U)};
    const std::size_t behind = offset + profile_05_crc_length;
    std::uint16_t crc = Crc16CcittFalse::update(Crc16CcittFalse::start, payload, offset);
    crc = Crc16CcittFalse::update(crc, payload + behind, length - behind);
    return Crc16CcittFalse::update(crc, suffix.data(), suffix.size());
}

}  // namespace detail

// Writes counter and CRC into a payload that holds its signals already.
template <std::size_t offset = 0U, std::size_t size>
constexpr void protect_profile_05(std::array<std::uint8_t, size>& payload, std::uint16_t data_id,
                                  std::uint8_t counter) {
    static_assert(size >= offset + profile_05_header_length, "profile 5 needs three bytes of the payload");
    payload[offset + profile_05_crc_length] = counter;
    const std::uint16_t crc = detail::profile_05_crc(payload.data(), size, offset, data_id);
    payload[offset] = static_cast<std::uint8_t>(crc & 0xFFU);
    payload[offset + 1U] = static_cast<std::uint8_t>(crc >> 8U);
}

// What is wrong with a received payload of `length` bytes, taken by itself: everything but the sequence.
constexpr CheckError verify_profile_05(const std::uint8_t* payload, std::size_t length,
                                       std::size_t expected_length, std::size_t offset,
                                       std::uint16_t data_id) {
    if (length != expected_length || length < offset + profile_05_header_length) {
        return CheckError::length;
    }
    const unsigned received = payload[offset] | (static_cast<unsigned>(payload[offset + 1U]) << 8U);
    return received == detail::profile_05_crc(payload, length, offset, data_id) ? CheckError::none
                                                                                : CheckError::crc;
}

// `offset` is Message::e2e_offset.
template <std::size_t offset>
struct Profile05 {
    static constexpr unsigned counter_range = profile_05_counter_range;

    template <std::size_t size>
    static constexpr void protect(std::array<std::uint8_t, size>& payload, std::uint16_t data_id,
                                  std::uint8_t counter) {
        protect_profile_05<offset>(payload, data_id, counter);
    }
    static constexpr CheckError verify(const std::uint8_t* payload, std::size_t length,
                                       std::size_t expected_length, std::uint16_t data_id) {
        return verify_profile_05(payload, length, expected_length, offset, data_id);
    }
    static constexpr std::uint8_t counter(const std::uint8_t* payload) {
        return payload[offset + profile_05_crc_length];
    }
};

template <std::size_t offset = 0U>
using Profile05Sender = Sender<Profile05<offset>>;
template <std::size_t offset = 0U>
using Profile05Receiver = Receiver<Profile05<offset>>;

}  // namespace can_dbc::e2e
