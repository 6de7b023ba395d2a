// Little-endian access to byte buffers, independent of the target's byte order. `bytes` has room for the
// whole value at `offset`; no alignment is needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace rsi::application {

constexpr std::uint32_t u16_at(const std::uint8_t* bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) | (static_cast<std::uint32_t>(bytes[offset + 1U]) << 8U);
}

constexpr std::uint32_t u32_at(const std::uint8_t* bytes, std::size_t offset) {
    return u16_at(bytes, offset) | (u16_at(bytes, offset + 2U) << 16U);
}

constexpr void put_u32(std::uint8_t* bytes, std::size_t offset, std::uint32_t value) {
    for (std::size_t byte = 0U; byte < 4U; ++byte) {
        bytes[offset + byte] = static_cast<std::uint8_t>(value >> (8U * byte));
    }
}

static_assert(sizeof(float) == sizeof(std::uint32_t), "a float is stored as IEEE 754 binary32");

inline std::uint32_t float_bits(float value) {
    std::uint32_t bits = 0U;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

inline float float_at(const std::uint8_t* bytes, std::size_t offset) {
    const std::uint32_t bits = u32_at(bytes, offset);
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

}  // namespace rsi::application
