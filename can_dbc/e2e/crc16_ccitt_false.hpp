// CRC-16 with the polynomial of CCITT (0x1021), most significant bit first, start value 0xFFFF, no final xor:
// what AUTOSAR's end-to-end profile 5 uses. Catalogues call it CRC-16/CCITT-FALSE or CRC-16/IBM-3740.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace can_dbc::e2e {

inline constexpr std::uint16_t crc16_ccitt_false_start = 0xFFFFU;

namespace detail {

constexpr std::array<std::uint16_t, 256> make_crc16_table(std::uint16_t polynomial) {
    std::array<std::uint16_t, 256> table{};
    for (std::size_t index = 0U; index < table.size(); ++index) {
        unsigned remainder = static_cast<unsigned>(index) << 8U;
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            remainder = (remainder & 0x8000U) != 0U ? (remainder << 1U) ^ polynomial : remainder << 1U;
        }
        table[index] = static_cast<std::uint16_t>(remainder & 0xFFFFU);
    }
    return table;
}

inline constexpr std::array<std::uint16_t, 256> crc16_ccitt_table = make_crc16_table(0x1021U);

}  // namespace detail

// The remainder after `length` more bytes; begin with crc16_ccitt_false_start.
constexpr std::uint16_t crc16_ccitt_false_update(std::uint16_t remainder, const std::uint8_t* data,
                                                 std::size_t length) {
    for (std::size_t index = 0U; index < length; ++index) {
        const unsigned high = (static_cast<unsigned>(remainder) >> 8U) ^ data[index];
        const unsigned low = (static_cast<unsigned>(remainder) << 8U) & 0xFFFFU;
        remainder = static_cast<std::uint16_t>(low ^ detail::crc16_ccitt_table[high]);
    }
    return remainder;
}

// The plain checksum. "123456789" gives 0x29B1.
constexpr std::uint16_t crc16_ccitt_false(const std::uint8_t* data, std::size_t length) {
    return crc16_ccitt_false_update(crc16_ccitt_false_start, data, length);
}

}  // namespace can_dbc::e2e
