// Stored count: a number that outlives a loss of power, in a record of its own.
//
//   offset  bytes
//        0      4  tag: whose count it is
//        4      4  the count
//        8      4  the count with every bit inverted
//
// Every number is little-endian, whatever the target.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/interface/storage.hpp"

namespace access_control {

inline constexpr std::size_t stored_count_length = 12U;

enum class CountState : std::uint8_t {
    absent,   // nothing has been stored yet, or it cannot be read
    damaged,  // or of another tag
    good,
};

// `count` is written only when the state is `good`.
[[gnu::cold]] CountState read_count(hal::Storage& storage, std::uint32_t tag, std::uint32_t& count) noexcept;

// False where the storage does not take it now.
bool write_count(hal::Storage& storage, std::uint32_t tag, std::uint32_t count) noexcept;

}  // namespace access_control
