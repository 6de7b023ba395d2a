// Place of a signal in a payload; reads and writes its bits on any host.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rsi::can_dbc {

enum class ByteOrder : std::uint8_t {
    little_endian,  // Intel: `start_bit` is the least significant bit
    big_endian,     // Motorola: `start_bit` is the most significant bit
};

// Bits are numbered as in a DBC file: bit b is bit b % 8 of byte b / 8, whatever the byte order.
struct BitField {
    ByteOrder byte_order;
    std::uint16_t start_bit;
    std::uint8_t length;  // 1 to 32
    bool is_signed;       // two's complement
};

namespace detail {

// The part of a field that lies in one byte: `count` bits, the lowest of them at `shift`.
struct BytePart {
    std::size_t byte;
    unsigned shift;
    unsigned count;
    unsigned position;  // of the part's lowest bit within the field's value
};

// The field's part in the `index`-th byte that it touches, of which there are at most five; of no bits where
// it touches fewer.
[[gnu::always_inline]] constexpr BytePart part_of(const BitField& field, unsigned index) {
    const bool little_endian = field.byte_order == ByteOrder::little_endian;
    const unsigned bit = field.start_bit % 8U;
    const unsigned room = (index > 0U) ? 8U : (little_endian ? 8U - bit : bit + 1U);
    const unsigned before = (index > 0U) ? 8U * index - (little_endian ? bit : 7U - bit) : 0U;
    const unsigned remaining = (before < field.length) ? field.length - before : 0U;
    const unsigned count = (room < remaining) ? room : remaining;
    const unsigned first = (index > 0U) ? (little_endian ? 0U : 8U) : (little_endian ? bit : bit + 1U);
    return BytePart{field.start_bit / 8U + index, little_endian ? first : first - count, count,
                    little_endian ? before : remaining - count};
}

template <unsigned index>
[[gnu::always_inline]] constexpr std::uint32_t read_part(const BitField& field, const std::uint8_t* payload) {
    const BytePart part = part_of(field, index);
    if (part.count == 0U) {
        return 0U;
    }
    const std::uint32_t mask = (1U << part.count) - 1U;
    return ((static_cast<std::uint32_t>(payload[part.byte]) >> part.shift) & mask) << part.position;
}

template <unsigned index>
[[gnu::always_inline]] constexpr void write_part(const BitField& field, std::uint32_t bits,
                                                 std::uint8_t* payload) {
    const BytePart part = part_of(field, index);
    if (part.count == 0U) {
        return;
    }
    const unsigned mask = (1U << part.count) - 1U;
    const unsigned kept = payload[part.byte] & ~(mask << part.shift);
    const unsigned added = (static_cast<std::uint8_t>(bits >> part.position) & mask) << part.shift;
    payload[part.byte] = static_cast<std::uint8_t>(kept | added);
}

}  // namespace detail

// Both without a loop, and part of the caller: of a field that the compiler knows only its bytes are left,
// which saves the control unit a twelfth of its cycle.

// Reads a field. The payload must reach to the field's last byte.
[[gnu::always_inline]] constexpr std::int64_t read_bits(const BitField& field, const std::uint8_t* payload) {
    const std::uint32_t bits = detail::read_part<0U>(field, payload) | detail::read_part<1U>(field, payload) |
                               detail::read_part<2U>(field, payload) | detail::read_part<3U>(field, payload) |
                               detail::read_part<4U>(field, payload);
    const std::int64_t magnitude = bits;
    const bool negative = field.is_signed && ((bits >> (field.length - 1U)) & 1U) != 0U;
    return negative ? magnitude - static_cast<std::int64_t>(std::uint64_t{1} << field.length) : magnitude;
}

// Writes the lowest `length` bits of `raw` and leaves every other bit of the payload as it is.
[[gnu::always_inline]] constexpr void write_bits(const BitField& field, std::int64_t raw,
                                                 std::uint8_t* payload) {
    const auto bits = static_cast<std::uint32_t>(raw);  // at most 32 of them are a field's
    detail::write_part<0U>(field, bits, payload);
    detail::write_part<1U>(field, bits, payload);
    detail::write_part<2U>(field, bits, payload);
    detail::write_part<3U>(field, bits, payload);
    detail::write_part<4U>(field, bits, payload);
}

}  // namespace rsi::can_dbc
