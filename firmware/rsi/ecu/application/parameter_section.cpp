#include "rsi/ecu/application/parameter_section.hpp"

#include <cstring>

#include "rsi/ecu/application/little_endian.hpp"

namespace rsi::application {
namespace {

bool has_magic(const std::uint8_t* bytes, std::size_t length) {
    bool same = (length >= section::magic.size());
    for (std::size_t index = 0U; same && (index < section::magic.size()); ++index) {
        same = (bytes[index] == section::magic[index]);
    }
    return same;
}

// First fault of the section, its values left aside.
ParametersRefusal check_form(const std::uint8_t* bytes, std::size_t length) {
    if (!has_magic(bytes, length)) {
        return ParametersRefusal::missing;
    }
    if (length < section::values_at) {
        return ParametersRefusal::length;
    }
    if (u16_at(bytes, section::version_at) != section::format_version) {
        return ParametersRefusal::version;
    }
    if ((u16_at(bytes, section::count_at) != section::value_count) ||
        (u32_at(bytes, section::layout_at) != section::layout)) {
        return ParametersRefusal::layout;
    }
    if ((length < section::length) || (u32_at(bytes, section::length_at) != section::length)) {
        return ParametersRefusal::length;
    }
    const bool intact = (crc32(bytes, section::checksum_at) == u32_at(bytes, section::checksum_at));
    return intact ? ParametersRefusal::none : ParametersRefusal::checksum;
}

}  // namespace

rsi::Parameters section::values_of(const std::uint8_t* bytes) noexcept {
    rsi::Parameters parameters{};
    std::size_t place = values_at;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        parameters.*field.member = float_at(bytes, place);
        place += 4U;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        const std::uint32_t word = u32_at(bytes, place);
        std::memcpy(&(parameters.*field.member), &word, sizeof word);
        place += 4U;
    }
    return parameters;
}

void section::put_checksum(std::uint8_t* bytes) noexcept {
    put_u32(bytes, checksum_at, crc32(bytes, checksum_at));
}

ParameterSectionAnswer read_parameter_section(const std::uint8_t* bytes, std::size_t length,
                                              rsi::Parameters& parameters) noexcept {
    ParameterSectionAnswer answer{check_form(bytes, length), rsi::Validation{0, "", ""}};
    if (answer.refusal != ParametersRefusal::none) {
        return answer;
    }
    const rsi::Parameters read = section::values_of(bytes);
    answer.validation = rsi::validate(read);
    if (answer.validation.accepted != 0) {
        parameters = read;
    } else {
        answer.refusal = ParametersRefusal::value;
    }
    return answer;
}

}  // namespace rsi::application
