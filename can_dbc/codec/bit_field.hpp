// Where a signal lies in a payload, and how its bits are read and written on any host.
#pragma once

#include <cstddef>
#include <cstdint>

namespace can_dbc {

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

// Walks the bytes that a field touches and calls `visit(BytePart)` for each; at most five.
template <typename Visitor>
constexpr void for_each_part(const BitField& field, Visitor&& visit) {
    std::size_t byte = field.start_bit / 8U;
    unsigned bit = field.start_bit % 8U;
    unsigned remaining = field.length;
    const bool little_endian = field.byte_order == ByteOrder::little_endian;
    while (remaining > 0U) {
        const unsigned room = little_endian ? 8U - bit : bit + 1U;
        const unsigned count = room < remaining ? room : remaining;
        const unsigned shift = little_endian ? bit : bit + 1U - count;
        const unsigned position = little_endian ? field.length - remaining : remaining - count;
        visit(BytePart{byte, shift, count, position});
        ++byte;
        bit = little_endian ? 0U : 7U;
        remaining -= count;
    }
}

}  // namespace detail

// Reads a field. The payload must reach to the field's last byte.
constexpr std::int64_t read_bits(const BitField& field, const std::uint8_t* payload) {
    std::uint32_t bits = 0U;
    detail::for_each_part(field, [&bits, payload](const detail::BytePart& part) {
        const std::uint32_t mask = (1U << part.count) - 1U;
        bits |= ((static_cast<std::uint32_t>(payload[part.byte]) >> part.shift) & mask) << part.position;
    });
    const std::int64_t magnitude = bits;
    const bool negative = field.is_signed && ((bits >> (field.length - 1U)) & 1U) != 0U;
    return negative ? magnitude - static_cast<std::int64_t>(std::uint64_t{1} << field.length) : magnitude;
}

// Writes the lowest `length` bits of `raw` and leaves every other bit of the payload as it is.
constexpr void write_bits(const BitField& field, std::int64_t raw, std::uint8_t* payload) {
    const auto bits = static_cast<std::uint32_t>(raw);  // at most 32 of them are a field's
    detail::for_each_part(field, [bits, payload](const detail::BytePart& part) {
        const unsigned mask = (1U << part.count) - 1U;
        const unsigned kept = payload[part.byte] & ~(mask << part.shift);
        const unsigned added = (static_cast<std::uint8_t>(bits >> part.position) & mask) << part.shift;
        payload[part.byte] = static_cast<std::uint8_t>(kept | added);
    });
}

}  // namespace can_dbc
