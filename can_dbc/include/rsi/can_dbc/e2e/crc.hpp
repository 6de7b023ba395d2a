// CRCs of 8 and 16 bits, most significant bit first, by table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace rsi::can_dbc::e2e {

namespace detail {

template <typename Remainder>
inline constexpr unsigned crc_width = 8U * sizeof(Remainder);

template <typename Remainder>
constexpr std::array<Remainder, 256> make_crc_table(Remainder polynomial) {
    constexpr unsigned width = crc_width<Remainder>;
    std::array<Remainder, 256> table{};
    for (unsigned index = 0U; index < table.size(); ++index) {
        unsigned remainder = index << (width - 8U);
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            const bool top = ((remainder >> (width - 1U)) & 1U) != 0U;
            remainder = top ? (remainder << 1U) ^ polynomial : remainder << 1U;
        }
        table[index] = static_cast<Remainder>(remainder);  // its lowest bits
    }
    return table;
}

template <typename Remainder, Remainder polynomial>
inline constexpr std::array<Remainder, 256> crc_table = make_crc_table<Remainder>(polynomial);

}  // namespace detail

// The width is that of `Remainder`. `start_value` and `final_xor` are the plain checksum's; a protection
// profile that has its own goes by `update` alone.
template <typename Remainder, Remainder polynomial, Remainder start_value, Remainder final_xor>
struct Crc {
    static_assert(sizeof(Remainder) <= 2U, "the arithmetic is in 32 bits");

    static constexpr Remainder start = start_value;

    // The remainder after one more byte.
    static constexpr Remainder update(Remainder remainder, std::uint8_t byte) {
        const unsigned wide = static_cast<unsigned>(remainder);
        const unsigned top = (wide >> (detail::crc_width<Remainder> - 8U)) ^ byte;
        return static_cast<Remainder>((wide << 8U) ^ detail::crc_table<Remainder, polynomial>[top]);
    }

    // After `length` more bytes.
    static constexpr Remainder update(Remainder remainder, const std::uint8_t* data, std::size_t length) {
        for (std::size_t index = 0U; index < length; ++index) {
            remainder = update(remainder, data[index]);
        }
        return remainder;
    }

    // After the bytes of `payload` from `begin` on, without a loop, which would be half of the work.
    template <std::size_t begin, std::size_t size>
    static constexpr Remainder update_from(Remainder remainder,
                                           const std::array<std::uint8_t, size>& payload) {
        return update_each(remainder, payload.data() + begin, std::make_index_sequence<size - begin>{});
    }

    // The plain checksum.
    static constexpr Remainder checksum(const std::uint8_t* data, std::size_t length) {
        return static_cast<Remainder>(update(start, data, length) ^ final_xor);
    }

 private:
    template <std::size_t... index>
    static constexpr Remainder update_each(Remainder remainder, const std::uint8_t* data,
                                           std::index_sequence<index...>) {
        ((remainder = update(remainder, data[index])), ...);
        return remainder;
    }
};

// Profiles 1 and 11. "123456789" gives 0x4B.
using Crc8SaeJ1850 = Crc<std::uint8_t, 0x1DU, 0xFFU, 0xFFU>;

}  // namespace rsi::can_dbc::e2e
