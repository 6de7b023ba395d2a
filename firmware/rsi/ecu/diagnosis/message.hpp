// Messages: a tester's request as it has come, and the answer to it, byte by byte.
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

    // 0: there is none.
    std::size_t length() const noexcept { return length_; }
    // Functionally addressed, not to this control unit alone.
    bool is_functional() const noexcept { return is_functional_; }

    // `place` is below length(), here and in the next two.
    std::uint8_t byte(std::size_t place) const noexcept { return bytes_[place]; }
    // The most significant byte first.
    std::uint32_t two_bytes(std::size_t place) const noexcept {
        return (static_cast<std::uint32_t>(byte(place)) << 8U) | byte(place + 1U);
    }
    std::uint32_t three_bytes(std::size_t place) const noexcept {
        return (two_bytes(place) << 8U) | byte(place + 2U);
    }

    std::uint8_t service() const noexcept { return byte(0U); }
    // Without the bit that suppresses a positive answer. Sub-function of a request with two bytes or more.
    std::uint8_t sub_function() const noexcept { return static_cast<std::uint8_t>(byte(1U) & 0x7FU); }

 private:
    const std::uint8_t* bytes_{nullptr};
    std::size_t length_{0U};
    bool is_functional_{false};
};

// Bytes that do not fit are left out and remembered.
class Response {
 public:
    static constexpr std::size_t capacity = 256U;

    // Begins anew, with a first byte.
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
    // The most significant byte first; of larger values the last bytes, here and in the next two.
    void put_two(std::uint32_t value) noexcept {
        put(static_cast<std::uint8_t>((value >> 8U) & 0xFFU));
        put(static_cast<std::uint8_t>(value & 0xFFU));
    }
    void put_three(std::uint32_t value) noexcept {
        put(static_cast<std::uint8_t>((value >> 16U) & 0xFFU));
        put_two(value);
    }
    void put_four(std::uint32_t value) noexcept {
        put_two(value >> 16U);
        put_two(value);
    }
    template <std::size_t count>
    void put_all(const std::array<std::uint8_t, count>& bytes) noexcept {
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
