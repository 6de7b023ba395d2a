// Diagnostic event: from a condition that comes and goes to a code that is set, confirmed and healed.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/diagnostic_code.hpp"

namespace rsi::monitoring {

enum class EventStatus : std::uint8_t {
    none,       // never confirmed, and nothing to be seen
    set,        // seen, but not for long enough
    confirmed,  // reacted to
    healed,     // was confirmed, and is good again
};

// A cycle with the fault fills the count by two, a good one takes one away: a fault that shows in every
// second cycle is confirmed too, after half as much time again, one in every third never. A confirmed one
// heals only by good cycles without a break.
class DiagnosticEvent {
 public:
    // One cycle in which the condition could be judged. True when it is confirmed by this one.
    constexpr bool update(bool failed, const Debounce& debounce) noexcept {
        if (status_ == EventStatus::confirmed) {
            heal(failed, debounce.heal);
            return false;
        }
        fill(failed);
        if (count_ < filled_by_fault * debounce.confirm) {
            status_ = (count_ > 0U) ? EventStatus::set : inactive_status();
            return false;
        }
        status_ = EventStatus::confirmed;
        count_ = 0U;
        occurrences_ = (occurrences_ < most_occurrences) ? static_cast<std::uint8_t>(occurrences_ + 1U)
                                                         : most_occurrences;
        return true;
    }

    // A good cycle changes nothing.
    constexpr bool is_inactive() const noexcept {
        return (status_ == EventStatus::none) || (status_ == EventStatus::healed);
    }
    constexpr EventStatus status() const noexcept { return status_; }
    constexpr bool confirmed() const noexcept { return status_ == EventStatus::confirmed; }
    // How often it was confirmed; stays at 31, the largest that the bus can carry.
    constexpr std::uint8_t occurrences() const noexcept { return occurrences_; }

 private:
    static constexpr std::uint32_t filled_by_fault = 2U;
    static constexpr std::uint8_t most_occurrences = 31U;

    constexpr EventStatus inactive_status() const noexcept {
        return (occurrences_ > 0U) ? EventStatus::healed : EventStatus::none;
    }

    constexpr void fill(bool failed) noexcept {
        if (failed) {
            count_ += filled_by_fault;
        } else {
            count_ -= (count_ > 0U) ? 1U : 0U;
        }
    }

    // While confirmed, count_ counts the good cycles.
    constexpr void heal(bool failed, std::uint32_t cycles) noexcept {
        count_ = failed ? 0U : count_ + 1U;
        if (count_ >= cycles) {
            status_ = EventStatus::healed;
            count_ = 0U;
        }
    }

    std::uint32_t count_{0U};
    std::uint8_t occurrences_{0U};
    EventStatus status_{EventStatus::none};
};

}  // namespace rsi::monitoring
