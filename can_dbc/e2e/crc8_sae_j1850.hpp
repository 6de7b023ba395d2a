// CRC-8 with the polynomial of SAE J1850 (0x1D), as AUTOSAR's end-to-end profiles 1 and 11 use it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace can_dbc::e2e {

namespace detail {

constexpr std::array<std::uint8_t, 256> make_crc8_table(std::uint8_t polynomial) {
    std::array<std::uint8_t, 256> table{};
    for (unsigned index = 0U; index < table.size(); ++index) {
        unsigned remainder = index;
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            remainder = (remainder & 0x80U) != 0U ? (remainder << 1U) ^ polynomial : remainder << 1U;
        }
        table[index] = static_cast<std::uint8_t>(remainder & 0xFFU);
    }
    return table;
}

inline constexpr std::array<std::uint8_t, 256> crc8_sae_j1850_table = make_crc8_table(0x1DU);

}  // namespace detail

// The remainder after `length` more bytes, most significant bit first; no start value and no final xor of its
// own.
constexpr std::uint8_t crc8_sae_j1850_update(std::uint8_t remainder, const std::uint8_t* data,
                                             std::size_t length) {
    for (std::size_t index = 0U; index < length; ++index) {
        remainder = detail::crc8_sae_j1850_table[static_cast<std::size_t>(remainder ^ data[index])];
    }
    return remainder;
}

// The plain checksum: start value 0xFF, final xor 0xFF. "123456789" gives 0x4B.
constexpr std::uint8_t crc8_sae_j1850(const std::uint8_t* data, std::size_t length) {
    return static_cast<std::uint8_t>(crc8_sae_j1850_update(0xFFU, data, length) ^ 0xFFU);
}

}  // namespace can_dbc::e2e
