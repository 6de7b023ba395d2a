#include "monitoring/diagnostic_memory.hpp"

namespace monitoring {

void DiagnosticMemory::report(DiagnosticCode code, bool failed) noexcept {
    Entry& entry = entries_[index_of(code)];
    const bool first = (entry.event.occurrences() == 0U);
    if (entry.event.update(failed, debounce_of(code)) && first) {
        entry.first = snapshot_;
    }
}

DiagnosticRecord DiagnosticMemory::next() noexcept {
    for (std::size_t step = 0U; step < diagnostic_code_count; ++step) {
        told_ = (told_ + 1U < diagnostic_code_count) ? told_ + 1U : 0U;
        const Entry& entry = entries_[told_];
        if (entry.event.status() != EventStatus::none) {
            return DiagnosticRecord{static_cast<DiagnosticCode>(told_), entry.event.status(),
                                    entry.event.occurrences(), entry.first};
        }
    }
    return DiagnosticRecord{};
}

}  // namespace monitoring
