// Diagnostic event: counter-based debouncing and healing of one diagnostic code.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/diagnostic_code.hpp"

namespace rsi::monitoring {

enum class EventStatus : std::uint8_t {
    none,       // never confirmed, count is zero
    set,        // the debounce count is running ("prefailed" in AUTOSAR)
    confirmed,  // debounced; the reaction is active
    healed,     // was confirmed, passes now
};

// Asymmetric up-down counter: a failed cycle counts up by two, a passed one down by one. A fault in every
// second cycle is therefore confirmed too, after 4 n - 3 cycles instead of n (`Debounce::confirm`), and one
// in every third cycle never, unless n is 1. A confirmed code heals only after consecutive passed cycles.
class DiagnosticEvent {
 public:
    // One cycle in which the condition could be judged. True in the cycle that confirms the code.
    constexpr bool update(bool failed, const Debounce& debounce) noexcept {
        if (status_ == EventStatus::confirmed) {
            heal(failed, debounce.heal);
            return false;
        }
        count_cycle(failed);
        if (count_ < failed_step * debounce.confirm) {
            status_ = (count_ > 0U) ? EventStatus::set : inactive_status();
            return false;
        }
        status_ = EventStatus::confirmed;
        count_ = 0U;
        occurrences_ = (occurrences_ < largest_occurrences) ? static_cast<std::uint8_t>(occurrences_ + 1U)
                                                            : largest_occurrences;
        return true;
    }

    // A passed cycle would change nothing, so it need not be reported.
    constexpr bool is_inactive() const noexcept {
        return (status_ == EventStatus::none) || (status_ == EventStatus::healed);
    }
    // 127 when confirmed; before that the count's share of it.
    constexpr std::uint8_t fault_detection_counter(const Debounce& debounce) const noexcept {
        constexpr std::uint32_t failed = 127U;
        const std::uint32_t share = failed * count_ / (failed_step * debounce.confirm);
        return static_cast<std::uint8_t>(confirmed() ? failed : share);
    }
    // Forgets a count that has not confirmed the code.
    constexpr void restart() noexcept {
        if (status_ == EventStatus::set) {
            count_ = 0U;
            status_ = inactive_status();
        }
    }
    constexpr EventStatus status() const noexcept { return status_; }
    constexpr bool confirmed() const noexcept { return status_ == EventStatus::confirmed; }
    // Number of confirmations; saturates at 31, the range of the signal Occurrences.
    constexpr std::uint8_t occurrences() const noexcept { return occurrences_; }

 private:
    static constexpr std::uint32_t failed_step = 2U;
    static constexpr std::uint8_t largest_occurrences = 31U;

    constexpr EventStatus inactive_status() const noexcept {
        return (occurrences_ > 0U) ? EventStatus::healed : EventStatus::none;
    }

    constexpr void count_cycle(bool failed) noexcept {
        if (failed) {
            count_ += failed_step;
        } else {
            count_ -= (count_ > 0U) ? 1U : 0U;
        }
    }

    // While confirmed, count_ is the number of consecutive passed cycles.
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
