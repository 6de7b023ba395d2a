// A second CRC-32, which shares nothing with the firmware's.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fuzz {

// As the polynomial division that it is, most significant bit first: generator 0x104C11DB7, a table of what a
// byte leaves.
std::uint32_t crc32_by_division(const std::uint8_t* bytes, std::size_t length);

}  // namespace fuzz
