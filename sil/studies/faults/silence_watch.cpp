#include "sil/studies/faults/silence_watch.hpp"

#include <algorithm>

namespace sil {

bool SilenceWatch::cycle(const std::optional<EcuAnswer>& faulty, const EcuAnswer& right, float right_level,
                         bool near, EnduranceResult& result) {
    const bool warns = right.state == WarningState::warning;
    if (warns && !warned_) {
        ++result.warnings_due;
        with_fault_ = answered_ = reported_ = silent_ = false;
    }
    if (!warns && warned_) {
        count(result);
    }
    warned_ = warns;
    const bool due = warns && right_level >= warning_off_;
    with_fault_ = with_fault_ || (due && near);
    answered_ = answered_ || (due && faulty && faulty->state == WarningState::warning);
    reported_ =
        reported_ || (due && faulty && (faulty->state == WarningState::unavailable || faulty->codes.any()));
    const bool is_silent = due && faulty && faulty->state == WarningState::ready && faulty->codes.none();
    silence_ms_ = is_silent ? silence_ms_ + 10 : 0;
    result.longest_silence_ms = std::max(result.longest_silence_ms, silence_ms_);
    const bool first = is_silent && !silent_;
    silent_ = silent_ || is_silent;
    return first;
}

void SilenceWatch::count(EnduranceResult& result) const {
    if (!with_fault_) {
        return;
    }
    ++result.due_with_fault;
    if (silent_) {
        ++result.due_with_fault_silenced;
    } else if (answered_) {
        ++result.due_with_fault_warned;
    } else if (reported_) {
        ++result.due_with_fault_reported;
    }
}

}  // namespace sil
