#include "rsi/ecu/monitoring/diagnostic_memory.hpp"

namespace rsi::monitoring {
namespace {

// Mask against bits without an entry, in case the memory of a set is damaged.
constexpr CodeSet all_codes = (CodeSet{1U} << diagnostic_code_count) - 1U;

// Index of the lowest set bit. Precondition: bits != 0. In halves, because 32-bit controllers have an
// instruction for these.
std::size_t lowest_bit(std::uint64_t bits) noexcept {
    const auto low = static_cast<std::uint32_t>(bits);
    const auto high = static_cast<std::uint32_t>(bits >> 32U);
    return static_cast<std::size_t>((low != 0U) ? __builtin_ctz(low) : 32 + __builtin_ctz(high));
}

CodeSet with_or_without(CodeSet codes, CodeSet bit, bool with) noexcept {
    return with ? (codes | bit) : (codes & ~bit);
}

}  // namespace

void DiagnosticMemory::update(DiagnosticCode code, bool failed, const Debounce& debounce) noexcept {
    Entry& entry = entries_[index_of(code)];
    const bool first = (entry.event.occurrences() == 0U);
    const CodeSet bit = CodeSet{1U} << index_of(code);
    if (entry.event.update(failed, debounce)) {
        unreported_ |= bit;
        entry.first = first ? snapshot_ : entry.first;
    }
    seen_ = with_or_without(seen_, bit, entry.event.status() != EventStatus::none);
    active_ = with_or_without(active_, bit, !entry.event.is_inactive());
    confirmed_ = with_or_without(confirmed_, bit, entry.event.confirmed());
}

std::uint8_t DiagnosticMemory::fault_detection_counter(DiagnosticCode code) const noexcept {
    return entries_[index_of(code)].event.fault_detection_counter(debounce_of(code));
}

void DiagnosticMemory::restart(CodeSet codes) noexcept {
    for (std::size_t index = 1U; index < diagnostic_code_count; ++index) {
        const CodeSet bit = CodeSet{1U} << index;
        if ((codes & bit) != 0U) {
            Entry& entry = entries_[index];
            entry.event.restart();
            seen_ = with_or_without(seen_, bit, entry.event.status() != EventStatus::none);
            active_ = with_or_without(active_, bit, !entry.event.is_inactive());
        }
    }
}

DiagnosticRecord DiagnosticMemory::next() noexcept {
    const std::size_t index = next_to_report();
    const Entry& entry = entries_[index];
    return DiagnosticRecord{static_cast<DiagnosticCode>(index), entry.event.status(),
                            entry.event.occurrences(), entry.first};
}

// 0, the entry of `none`, if there is nothing to report.
std::size_t DiagnosticMemory::next_to_report() noexcept {
    const CodeSet unreported = unreported_ & all_codes;
    if (unreported != 0U) {
        const std::size_t index = next_of(unreported);
        unreported_ &= ~(CodeSet{1U} << index);
        return index;
    }
    const CodeSet seen = seen_ & all_codes;
    last_reported_ = (seen != 0U) ? next_of(seen) : 0U;
    return last_reported_;
}

// First code of `codes` after last_reported_, round robin. Precondition: codes != 0.
std::size_t DiagnosticMemory::next_of(CodeSet codes) const noexcept {
    const std::size_t last = (last_reported_ < diagnostic_code_count) ? last_reported_ : 0U;
    const CodeSet later = codes & ~((CodeSet{2U} << last) - 1U);
    return lowest_bit((later != 0U) ? later : codes);
}

}  // namespace rsi::monitoring
