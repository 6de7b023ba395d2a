// Section record: the parameter section that XCP or a tester has stored, in two places of non-volatile memory
// in turn.
#pragma once

#include <array>
#include <cstdint>

#include "rsi/ecu/application/alternating_record.hpp"
#include "rsi/ecu/application/section_authority.hpp"
#include "rsi/ecu/application/write_pace.hpp"

namespace rsi::application {

// A section, and behind it its seal or zeros.
using SectionBytes = std::array<std::uint8_t, seal::sealed_length>;

extern template class AlternatingRecord<SectionBytes>;  // once for both

// One object for XCP and diagnosis together: each record has a number that follows that of the last.
class SectionRecord {
 public:
    static constexpr std::size_t length = AlternatingRecord<SectionBytes>::length;

    // As those of AlternatingRecord.
    SectionRecord(hal::Storage& one, hal::Storage& other) noexcept : record_{one, other} {}
    [[gnu::cold]] RecordState read(SectionBytes& bytes) noexcept { return record_.read(bytes); }
    bool write(const SectionBytes& bytes) noexcept;

    // Once a cycle while a section waits to be written: whether to try. A memory that refuses is tried ever
    // more rarely, at last once a second.
    bool is_due() noexcept;

    // The memory has refused many tries, and has taken none since.
    bool is_failing() const noexcept { return pace_.is_failing(); }

 private:
    AlternatingRecord<SectionBytes> record_;
    WritePace pace_{};
};

// Reason for which the memory of the section is not to be trusted, though a section may have been read.
constexpr ParametersRefusal refusal_of(RecordState state) noexcept {
    return ((state == RecordState::doubtful) || (state == RecordState::unreadable))
               ? ParametersRefusal::checksum
               : ParametersRefusal::none;
}

}  // namespace rsi::application
