// Numbers as bytes, the least significant first, whatever the target.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rsi::application {

constexpr std::uint32_t half_word_at(const std::uint8_t* bytes, std::size_t place) {
    return static_cast<std::uint32_t>(bytes[place]) | (static_cast<std::uint32_t>(bytes[place + 1U]) << 8U);
}

constexpr std::uint32_t word_at(const std::uint8_t* bytes, std::size_t place) {
    return half_word_at(bytes, place) | (half_word_at(bytes, place + 2U) << 16U);
}

constexpr void put_word(std::uint8_t* bytes, std::size_t place, std::uint32_t word) {
    for (std::size_t byte = 0U; byte < 4U; ++byte) {
        bytes[place + byte] = static_cast<std::uint8_t>(word >> (8U * byte));
    }
}

// A float is its bits (IEEE 754, binary32).
static_assert(sizeof(float) == sizeof(std::uint32_t));

inline std::uint32_t word_of(float value) {
    std::uint32_t word = 0U;
    std::memcpy(&word, &value, sizeof word);
    return word;
}

inline float float_at(const std::uint8_t* bytes, std::size_t place) {
    const std::uint32_t word = word_at(bytes, place);
    float value = 0.0F;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

}  // namespace rsi::application
