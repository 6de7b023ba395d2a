// Parameter section: the calibration as an image carries it, in a section of its own, so that it can be
// changed without a rebuild.
//
//   offset  bytes
//        0      4  magic, "RSIP"
//        4      2  format version, 1
//        6      2  number of values
//        8      4  layout: CRC-32 of the names of all values in their order, each selection's with its first
//        choices
//       12      4  length of the whole section
//       16     48  the calibration's name: text, padded with zeros
//       64   4 * n  the values in the order of rsi_parameters: floats (IEEE 754, binary32), then selections
//   at end      4  CRC-32 of every byte before
//
// Every number is little-endian, whatever the target. The layout detects a section that was written for
// another rsi_parameters, whose values would be assigned to the wrong fields.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/application/crc32.hpp"
#include "rsi/parameters.hpp"

namespace rsi::application {

// First reason to refuse the parameters of the last init; sent as the signal ParametersRefusal.
enum class ParametersRefusal : std::uint8_t {
    none = 0,
    missing = 1,      // not yet started, or no parameter section: the magic is not there (erased memory)
    version = 2,      // of another format
    layout = 3,       // written for another set of parameters, by another version of the tools
    length = 4,       // too little memory for a section, or a section of another length
    checksum = 5,     // CRC-32
    value = 6,        // outside its range, or in contradiction to another; the answer names it
    unauthentic = 7,  // without a good seal, or older than one that was in use (section_authority.hpp)
};

namespace section {

inline constexpr std::array<std::uint8_t, 4> magic{'R', 'S', 'I', 'P'};
inline constexpr std::uint16_t format_version = 1U;
inline constexpr std::size_t version_at = 4U;
inline constexpr std::size_t count_at = 6U;
inline constexpr std::size_t layout_at = 8U;
inline constexpr std::size_t length_at = 12U;
inline constexpr std::size_t name_at = 16U;
inline constexpr std::size_t name_length = 48U;
inline constexpr std::size_t values_at = 64U;
inline constexpr std::size_t float_count = rsi::parameter_fields.size();
inline constexpr std::size_t value_count = float_count + rsi::selection_fields.size();
inline constexpr std::size_t checksum_at = values_at + 4U * value_count;
inline constexpr std::size_t length = checksum_at + 4U;

static_assert(
    sizeof(rsi::Parameters) == 4U * value_count,
    "a field of rsi_parameters is missing in rsi/parameters.hpp, so the section would not carry it");
static_assert(name_at + name_length == values_at);

constexpr std::uint32_t add_word(std::uint32_t remainder, const char* text, char end) {
    for (; *text != '\0'; ++text) {
        remainder = crc32_update(remainder, static_cast<std::uint8_t>(*text));
    }
    return crc32_update(remainder, static_cast<std::uint8_t>(end));
}

// Choices that are added later are left out, so that sections in the field stay valid.
constexpr std::uint32_t layout_of_values() {
    std::uint32_t remainder = crc32_start;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        remainder = add_word(remainder, field.name, '\n');
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        remainder = add_word(remainder, field.name, ':');
        for (std::int32_t choice = 0; choice < field.choices_in_layout; ++choice) {
            remainder = add_word(remainder, field.choices[choice], ',');
        }
    }
    return crc32_end(remainder);
}

inline constexpr std::uint32_t layout = layout_of_values();

// Precondition: the section has passed every check but the one of its values. The parameters are not
// validated.
rsi::Parameters values_of(const std::uint8_t* bytes) noexcept;

// Updates the CRC after a change of values.
void put_checksum(std::uint8_t* bytes) noexcept;

}  // namespace section

// `validation` names the field that is refused when `refusal` is `value`; else it has no text.
struct ParameterSectionAnswer {
    ParametersRefusal refusal;
    rsi::Validation validation;
};

// Reads and validates the section at `bytes`. `length`: bytes that may be read, at least the section's
// length; never more than that is read. `parameters` is written only when nothing is refused.
ParameterSectionAnswer read_parameter_section(const std::uint8_t* bytes, std::size_t length,
                                              rsi::Parameters& parameters) noexcept;

}  // namespace rsi::application
