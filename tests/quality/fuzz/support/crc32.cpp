#include "tests/quality/fuzz/support/crc32.hpp"

#include <array>

namespace fuzz {
namespace {

constexpr std::uint32_t generator = 0x04C11DB7U;

// Remainder of eight bits, most significant first.
std::array<std::uint32_t, 256> remainders() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0U; byte < table.size(); ++byte) {
        std::uint32_t remainder = byte << 24U;
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            remainder = (remainder << 1U) ^ ((remainder >> 31U) != 0U ? generator : 0U);
        }
        table[byte] = remainder;
    }
    return table;
}

std::uint32_t reflected(std::uint32_t value, unsigned bits) {
    std::uint32_t mirrored = 0U;
    for (unsigned bit = 0U; bit < bits; ++bit) {
        mirrored |= ((value >> bit) & 1U) << (bits - 1U - bit);
    }
    return mirrored;
}

// A byte goes out with its least significant bit first.
std::array<std::uint8_t, 256> mirrored_bytes() {
    std::array<std::uint8_t, 256> table{};
    for (std::uint32_t byte = 0U; byte < table.size(); ++byte) {
        table[byte] = static_cast<std::uint8_t>(reflected(byte, 8U));
    }
    return table;
}

}  // namespace

std::uint32_t crc32_by_division(const std::uint8_t* bytes, std::size_t length) {
    static const std::array<std::uint32_t, 256> by_byte = remainders();
    static const std::array<std::uint8_t, 256> mirrored = mirrored_bytes();
    std::uint32_t remainder = 0xFFFFFFFFU;
    for (std::size_t index = 0U; index < length; ++index) {
        remainder = (remainder << 8U) ^ by_byte[(remainder >> 24U) ^ mirrored[bytes[index]]];
    }
    return ~reflected(remainder, 32U);
}

}  // namespace fuzz
