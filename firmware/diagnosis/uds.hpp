// Unified diagnostic services: the words of ISO 14229-1 that this server knows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace diagnosis {

enum class Session : std::uint8_t { standard = 1U, programming = 2U, extended = 3U };

enum class Nrc : std::uint8_t {
    none = 0x00U,  // a positive response
    service_not_supported = 0x11U,
    sub_function_not_supported = 0x12U,
    incorrect_length = 0x13U,
    response_too_long = 0x14U,
    conditions_not_correct = 0x22U,
    request_sequence_error = 0x24U,
    request_out_of_range = 0x31U,
    security_access_denied = 0x33U,
    invalid_key = 0x35U,
    exceeded_attempts = 0x36U,
    time_delay_not_expired = 0x37U,
    download_not_accepted = 0x70U,
    transfer_suspended = 0x71U,
    programming_failure = 0x72U,
    wrong_block_counter = 0x73U,
    response_pending = 0x78U,
    service_not_in_session = 0x7FU,
};

// A positive response, byte by byte. What does not fit is left out and remembered.
class Response {
 public:
    static constexpr std::size_t capacity = 256U;

    void begin(std::uint8_t service) noexcept {
        length_ = 0U;
        is_too_long_ = false;
        put(static_cast<std::uint8_t>(service + 0x40U));
    }
    void negative(std::uint8_t service, Nrc code) noexcept {
        length_ = 0U;
        put(0x7FU);
        put(service);
        put(static_cast<std::uint8_t>(code));
    }
    void put(std::uint8_t byte) noexcept {
        if (length_ < capacity) {
            bytes_[length_] = byte;
            ++length_;
        } else {
            is_too_long_ = true;
        }
    }
    // The most significant byte first.
    void put_16(std::uint32_t value) noexcept {
        put(static_cast<std::uint8_t>((value >> 8U) & 0xFFU));
        put(static_cast<std::uint8_t>(value & 0xFFU));
    }
    void put_24(std::uint32_t value) noexcept {
        put(static_cast<std::uint8_t>((value >> 16U) & 0xFFU));
        put_16(value & 0xFFFFU);
    }
    void put_32(std::uint32_t value) noexcept {
        put_16(value >> 16U);
        put_16(value & 0xFFFFU);
    }

    const std::uint8_t* bytes() const noexcept { return bytes_.data(); }
    std::size_t length() const noexcept { return length_; }
    bool is_too_long() const noexcept { return is_too_long_; }

 private:
    std::array<std::uint8_t, capacity> bytes_{};
    std::size_t length_{0U};
    bool is_too_long_{false};
};

constexpr std::uint32_t big_endian_16(const std::uint8_t* bytes) noexcept {
    return (static_cast<std::uint32_t>(bytes[0]) << 8U) | bytes[1];
}
constexpr std::uint32_t big_endian_24(const std::uint8_t* bytes) noexcept {
    return (big_endian_16(bytes) << 8U) | bytes[2];
}

}  // namespace diagnosis
