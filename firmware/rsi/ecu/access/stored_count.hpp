// Stored count: a number in non-volatile memory, in a record of its own.
//
//   offset  bytes
//        0      4  magic, CountOf
//        4      4  the count
//        8      4  the count with every bit inverted
//
// Every number is little-endian, whatever the target.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rsi/hal/storage.hpp"

namespace rsi::access {

inline constexpr std::size_t stored_count_length = 12U;

// Quantity that a record counts, by its magic.
enum class CountOf : std::uint32_t {
    wrong_keys = 0x4B49'5352U,       // "RSIK"
    section_versions = 0x5649'5352U  // "RSIV"
};

enum class CountState : std::uint8_t {
    absent,   // never stored
    damaged,  // not readable, inconsistent, or the record of another quantity
    good,
};

// `count` is written only when the state is `good`.
[[gnu::cold]] CountState read_count(hal::Storage& storage, CountOf what, std::uint32_t& count) noexcept;

// False if the storage is busy.
bool write_count(hal::Storage& storage, CountOf what, std::uint32_t count) noexcept;

}  // namespace rsi::access
