// CRC-32 of Ethernet, zip and PNG (CRC-32/ISO-HDLC): reflected polynomial 0xEDB88320, start and final xor all
// ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rsi::application {

inline constexpr std::uint32_t crc32_start = 0xFFFF'FFFFU;

// One entry per nibble: a bitwise CRC would be too slow for records that are stored within a cycle, and a
// table for bytes would take 1 KiB of constants.
inline constexpr std::array<std::uint32_t, 16> crc32_of_half_byte{
    0x0000'0000U, 0x1DB7'1064U, 0x3B6E'20C8U, 0x26D9'30ACU, 0x76DC'4190U, 0x6B6B'51F4U,
    0x4DB2'6158U, 0x5005'713CU, 0xEDB8'8320U, 0xF00F'9344U, 0xD6D6'A3E8U, 0xCB61'B38CU,
    0x9B64'C2B0U, 0x86D3'D2D4U, 0xA00A'E278U, 0xBDBD'F21CU};

// The remainder after one more byte.
constexpr std::uint32_t crc32_update(std::uint32_t remainder, std::uint8_t byte) {
    remainder ^= byte;
    remainder = (remainder >> 4U) ^ crc32_of_half_byte[remainder & 0x0FU];
    return (remainder >> 4U) ^ crc32_of_half_byte[remainder & 0x0FU];
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

}  // namespace rsi::application
