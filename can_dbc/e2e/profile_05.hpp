// AUTOSAR end-to-end protection, profile 5, for CAN FD.
//
// From byte `offset` on: the CRC in two bytes, low byte first, and the counter (0 to 255) in one. The CRC
// covers the whole payload but its own two bytes, and then the data identifier, low byte first, which is not
// sent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "can_dbc/e2e/check_status.hpp"
#include "can_dbc/e2e/counter_sequence.hpp"
#include "can_dbc/e2e/crc16_ccitt_false.hpp"

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
    std::uint16_t crc = crc16_ccitt_false_update(crc16_ccitt_false_start, payload, offset);
    crc = crc16_ccitt_false_update(crc, payload + behind, length - behind);
    return crc16_ccitt_false_update(crc, suffix.data(), suffix.size());
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

// Protects the frames of one sender and one data identifier, counting them. The caller owns it, one a
// message. `offset` is Message::e2e_offset.
template <std::size_t offset = 0U>
class Profile05Sender {
 public:
    constexpr explicit Profile05Sender(std::uint16_t data_id) : data_id_{data_id} {}

    template <std::size_t size>
    constexpr void protect(std::array<std::uint8_t, size>& payload) {
        protect_profile_05<offset>(payload, data_id_, counter_);
        counter_ = static_cast<std::uint8_t>((counter_ + 1U) % profile_05_counter_range);
    }

 private:
    std::uint16_t data_id_;
    std::uint8_t counter_{0U};
};

// Checks the frames of one data identifier as they arrive. The caller owns it, one a message. A damaged frame
// leaves the counter's reference alone; see CounterSequence.
template <std::size_t offset = 0U>
class Profile05Receiver {
 public:
    // `largest_counter_step` is how far the counter may advance between two frames, 1 to 255: 1 tolerates no
    // lost frame.
    constexpr Profile05Receiver(std::uint16_t data_id, std::size_t length, std::uint8_t largest_counter_step)
        : length_{length}, data_id_{data_id}, sequence_{largest_counter_step} {}

    // Judges one received frame: `length` is the frame's, which may be smaller than the array.
    template <std::size_t size>
    constexpr CheckResult check(const std::array<std::uint8_t, size>& payload, std::size_t length) {
        return length > size ? CheckResult{CheckStatus::error, CheckError::length}
                             : check(payload.data(), length);
    }

    // The outcome of a cycle without a frame.
    constexpr CheckResult no_frame() const { return CheckResult{}; }

 private:
    constexpr CheckResult check(const std::uint8_t* payload, std::size_t length) {
        const CheckError error = verify_profile_05(payload, length, length_, offset, data_id_);
        return error == CheckError::none ? sequence_.follow(payload[offset + profile_05_crc_length])
                                         : CheckResult{CheckStatus::error, error};
    }

    std::size_t length_;
    std::uint16_t data_id_;
    CounterSequence<profile_05_counter_range> sequence_;
};

}  // namespace can_dbc::e2e
