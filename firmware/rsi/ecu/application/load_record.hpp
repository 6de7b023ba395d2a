// Load record: the learnt load in the form in which non-volatile memory keeps it.
//
//   offset  bytes
//        0      4  magic, "RSIL"
//        4      4  CRC-32 of the parameters for which the load was learnt
//        8     12  excess, its deviation, offset in m/s^2: floats (IEEE 754, binary32)
//       20      4  CRC-32 of every byte before
//
// Every number is little-endian, whatever the target.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/types.hpp"

namespace rsi::application {

inline constexpr std::size_t load_record_length = 24U;
using LoadRecord = std::array<std::uint8_t, load_record_length>;

// CRC-32 of the parameters, as at offset 4.
[[gnu::cold]] std::uint32_t check_word_of(const rsi::Parameters& parameters) noexcept;

LoadRecord write_load_record(const rsi::LearntLoad& learnt, std::uint32_t parameters_check_word) noexcept;

// False where the record is damaged, erased or no load.
[[gnu::cold]] bool is_load_record(const LoadRecord& record) noexcept;

// Precondition: is_load_record. False where the load is of other parameters; `learnt` is then left as it was.
[[gnu::cold]] bool read_load_record(const LoadRecord& record, std::uint32_t parameters_check_word,
                                    rsi::LearntLoad& learnt) noexcept;

}  // namespace rsi::application
