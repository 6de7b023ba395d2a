// Load record: what driving has taught, in the form in which non-volatile memory keeps it.
//
//   offset  bytes
//        0      4  magic, "RSIM"
//        4      4  CRC-32 of the parameters for which it was learnt
//        8     12  load: excess, its deviation, offset in m/s^2: floats (IEEE 754, binary32)
//       20      4  offset of the lateral accelerometer in m/s^2: float
//       24      4  CRC-32 of every byte before
//
// Every number is little-endian, whatever the target.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/types.hpp"

namespace rsi::application {

inline constexpr std::size_t load_record_length = 28U;
using LoadRecord = std::array<std::uint8_t, load_record_length>;

struct Learnt {
    rsi::LearntLoad load{};
    float lateral_offset_mps2{0.0F};  // of the accelerometer
};

// CRC-32 of the parameters, as at offset 4.
[[gnu::cold]] std::uint32_t check_word_of(const rsi::Parameters& parameters) noexcept;

LoadRecord write_load_record(const Learnt& learnt, std::uint32_t parameters_check_word) noexcept;

// False where the record is damaged, erased or another.
[[gnu::cold]] bool is_load_record(const LoadRecord& record) noexcept;

// Precondition: is_load_record. False where it is of other parameters; `learnt` is then left as it was.
[[gnu::cold]] bool read_load_record(const LoadRecord& record, std::uint32_t parameters_check_word,
                                    Learnt& learnt) noexcept;

}  // namespace rsi::application
