// Calibration EPK ("EPROM Kennung", ASAM MCD-2 MC): identifier by which a tool checks that its A2L file fits
// this firmware.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/output_table.hpp"
#include "rsi/version.h"

namespace rsi::application {

template <typename Table>
constexpr std::uint32_t add_names(std::uint32_t remainder, const Table& table) {
    for (const auto& row : table) {
        remainder = section::add_word(remainder, row.name, '\n');
    }
    return remainder;
}

// Evaluated at compile time, so that the names do not get into the image.
constexpr std::uint32_t layout_of_outputs() {
    return crc32_end(add_names(add_names(crc32_start, rsi::code_outputs), rsi::number_outputs));
}

constexpr std::uint8_t digit_of(std::uint32_t nibble) {
    return static_cast<std::uint8_t>((nibble < 10U) ? '0' + nibble : 'A' + (nibble - 10U));
}

// "rsi 0.2.0 89ABCDEF 01234567", padded with zeros: version, layout of the parameters, layout of the outputs.
constexpr std::array<std::uint8_t, 32> make_calibration_epk() {
    std::array<std::uint8_t, 32> text{};
    std::size_t place = 0U;
    for (const char letter : "rsi " RSI_VERSION) {
        text[place] = static_cast<std::uint8_t>(letter);
        ++place;
    }
    --place;  // overwrites the terminating zero
    for (const std::uint32_t word : {section::layout, layout_of_outputs()}) {
        text[place] = ' ';
        ++place;
        for (std::uint32_t shift = 32U; shift > 0U; shift -= 4U) {
            text[place] = digit_of((word >> (shift - 4U)) & 0xFU);
            ++place;
        }
    }
    return text;
}

inline constexpr std::array<std::uint8_t, 32> calibration_epk = make_calibration_epk();

}  // namespace rsi::application
