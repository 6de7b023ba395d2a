// Section record: the parameter section that XCP or a tester has stored, in two places of non-volatile memory
// in turn.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/ecu/application/alternating_record.hpp"
#include "rsi/ecu/application/section_authority.hpp"

namespace rsi::application {

// A section, and behind it its seal or zeros.
using SectionBytes = std::array<std::uint8_t, seal::sealed_length>;

// One object for XCP and diagnosis together: each record has a number that follows that of the last.
using SectionRecord = AlternatingRecord<SectionBytes>;

// Reason for which the memory of the section is not to be trusted, though a section may have been read.
constexpr ParametersRefusal refusal_of(RecordState state) noexcept {
    return ((state == RecordState::doubtful) || (state == RecordState::unreadable))
               ? ParametersRefusal::checksum
               : ParametersRefusal::none;
}

extern template class AlternatingRecord<SectionBytes>;  // once for both

}  // namespace rsi::application
