// CRC-32 of Ethernet, zip and PNG (CRC-32/ISO-HDLC): reflected polynomial 0xEDB88320, start and final xor all
// ones.
#pragma once

#include <cstddef>
#include <cstdint>

namespace application {

inline constexpr std::uint32_t crc32_start = 0xFFFF'FFFFU;

// The remainder after one more byte. No table: it is computed once, at start, where 32 bytes of code are
// worth more than a thousand bytes of constants.
constexpr std::uint32_t crc32_update(std::uint32_t remainder, std::uint8_t byte) {
    remainder ^= byte;
    for (unsigned bit = 0U; bit < 8U; ++bit) {
        const std::uint32_t feedback = ((remainder & 1U) != 0U) ? 0xEDB8'8320U : 0U;
        remainder = (remainder >> 1U) ^ feedback;
    }
    return remainder;
}

constexpr std::uint32_t crc32_end(std::uint32_t remainder) {
    return remainder ^ 0xFFFF'FFFFU;
}

// "123456789" gives 0xCBF43926.
constexpr std::uint32_t crc32(const std::uint8_t* data, std::size_t length) {
    std::uint32_t remainder = crc32_start;
    for (std::size_t index = 0U; index < length; ++index) {
        remainder = crc32_update(remainder, data[index]);
    }
    return crc32_end(remainder);
}

}  // namespace application
