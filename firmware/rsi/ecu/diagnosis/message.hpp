// Messages: a tester's request as received, and the response to it. Multi-byte values are big-endian.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rsi::diagnosis {

class Request {
 public:
    Request() noexcept = default;
    // `bytes` must outlive the request.
    Request(const std::uint8_t* bytes, std::size_t length, bool is_functional) noexcept
        : bytes_{bytes}, length_{length}, is_functional_{is_functional} {}

    // In bytes; 0: no request is pending.
    std::size_t length() const noexcept { return length_; }
    // Functionally addressed, not to this control unit alone.
    bool is_functional() const noexcept { return is_functional_; }

    // Precondition of this and the next two: the value lies within length().
    std::uint8_t byte(std::size_t place) const noexcept { return bytes_[place]; }
    std::uint32_t u16_at(std::size_t place) const noexcept {
        return (static_cast<std::uint32_t>(byte(place)) << 8U) | byte(place + 1U);
    }
    std::uint32_t u24_at(std::size_t place) const noexcept {
        return (u16_at(place) << 8U) | byte(place + 2U);
    }

    std::uint8_t service() const noexcept { return byte(0U); }
    // Without suppressPosRspMsgIndicationBit. Precondition: the request has two bytes or more.
    std::uint8_t sub_function() const noexcept { return static_cast<std::uint8_t>(byte(1U) & 0x7FU); }

 private:
    const std::uint8_t* bytes_{nullptr};
    std::size_t length_{0U};
    bool is_functional_{false};
};

// Bytes beyond the capacity are dropped; is_too_long() then stays true until begin().
class Response {
 public:
    static constexpr std::size_t capacity = 256U;

    // Discards the content and puts a first byte.
    void begin(std::uint8_t byte) noexcept {
        length_ = 0U;
        is_too_long_ = false;
        put(byte);
    }
    void put(std::uint8_t byte) noexcept {
        if (length_ < capacity) {
            bytes_[length_] = byte;
            ++length_;
        } else {
            is_too_long_ = true;
        }
    }
    // This and the next two put the lowest bytes of `value`.
    void put_u16(std::uint32_t value) noexcept {
        put(static_cast<std::uint8_t>((value >> 8U) & 0xFFU));
        put(static_cast<std::uint8_t>(value & 0xFFU));
    }
    void put_u24(std::uint32_t value) noexcept {
        put(static_cast<std::uint8_t>((value >> 16U) & 0xFFU));
        put_u16(value);
    }
    void put_u32(std::uint32_t value) noexcept {
        put_u16(value >> 16U);
        put_u16(value);
    }
    template <std::size_t count>
    void put_bytes(const std::array<std::uint8_t, count>& bytes) noexcept {
        for (const std::uint8_t byte : bytes) {
            put(byte);
        }
    }

    std::uint8_t byte(std::size_t place) const noexcept { return bytes_[place]; }
    std::size_t length() const noexcept { return length_; }
    bool is_too_long() const noexcept { return is_too_long_; }

 private:
    std::array<std::uint8_t, capacity> bytes_{};
    std::size_t length_{0U};
    bool is_too_long_{false};
};

}  // namespace rsi::diagnosis
