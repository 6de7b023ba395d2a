#include "monitoring/diagnostic_memory.hpp"

namespace monitoring {

void DiagnosticMemory::update(DiagnosticCode code, bool failed) noexcept {
    empty_ = false;
    Entry& entry = entries_[index_of(code)];
    active_ -= entry.event.is_inactive() ? 0U : 1U;
    const bool first = (entry.event.occurrences() == 0U);
    if (entry.event.update(failed, debounce_of(code))) {
        entry.unreported = true;
        entry.first = first ? snapshot_ : entry.first;
    }
    active_ += entry.event.is_inactive() ? 0U : 1U;
}

DiagnosticRecord DiagnosticMemory::next() noexcept {
    const std::size_t index = next_to_report();
    Entry& entry = entries_[index];
    entry.unreported = false;
    return DiagnosticRecord{static_cast<DiagnosticCode>(index), entry.event.status(),
                            entry.event.occurrences(), entry.first};
}

// 0, the empty entry of `none`, when no other has something to report.
std::size_t DiagnosticMemory::next_to_report() noexcept {
    if (empty_) {
        return 0U;
    }
    std::size_t index = last_reported_;
    std::size_t found = 0U;
    for (std::size_t step = 0U; step < diagnostic_code_count; ++step) {
        index = (index + 1U < diagnostic_code_count) ? index + 1U : 0U;
        const Entry& entry = entries_[index];
        if (entry.unreported) {
            return index;
        }
        if ((found == 0U) && (entry.event.status() != EventStatus::none)) {
            found = index;
        }
    }
    last_reported_ = found;
    return found;
}

}  // namespace monitoring
