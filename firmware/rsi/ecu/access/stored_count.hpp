// Stored count: a number that outlives a loss of power, in a record of its own.
//
//   offset  bytes
//        0      4  what is counted
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

// Their numbers are in the record.
enum class CountOf : std::uint32_t {
    wrong_keys = 0x4B49'5352U,       // "RSIK"
    section_versions = 0x5649'5352U  // "RSIV"
};

enum class CountState : std::uint8_t {
    absent,   // nothing has been stored yet, or it cannot be read
    damaged,  // or of another count
    good,
};

// `count` is written only when the state is `good`.
[[gnu::cold]] CountState read_count(hal::Storage& storage, CountOf what, std::uint32_t& count) noexcept;

// False where the storage does not take it now.
bool write_count(hal::Storage& storage, CountOf what, std::uint32_t count) noexcept;

}  // namespace rsi::access
