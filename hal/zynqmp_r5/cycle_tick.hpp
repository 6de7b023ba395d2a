// Cycle tick: waits for the next multiple of the period and counts what was missed.
#pragma once

#include <cstdint>

#include "rsi/hal/clock.hpp"

namespace rsi::hal::zynqmp_r5 {

// More missed periods than this are not counted one by one: the tick starts anew. The watchdog has long acted
// then.
inline constexpr std::uint32_t most_missed_periods{1000U};

// `SourceClock` has now() and Time update(). Periods lie on a fixed grid, so that a late cycle does not shift
// the next.
template <typename SourceClock>
class CycleTick {
 public:
    // `clock` must outlive the tick. The first period begins now.
    CycleTick(SourceClock& clock, Time period) noexcept
        : clock_{clock}, period_{period}, due_{clock.now() + period} {}

    // Whether the next cycle is due; then `missed` is how many periods passed without one. Call it at least
    // every few tenths of a second, as the clock demands.
    bool is_due(std::uint32_t& missed) noexcept {
        const Time now = clock_.update();
        if (now < due_) {
            spare_ = due_ - now;
            return false;
        }
        spare_ = Time{};
        due_ = due_ + period_;
        missed = 0U;
        while (!(now < due_) && missed < most_missed_periods) {
            due_ = due_ + period_;
            ++missed;
        }
        if (!(now < due_)) {
            due_ = now + period_;
        }
        return true;
    }

    // Moves all cycles to come; `later` below zero: earlier.
    void shift(Time later) noexcept { due_ = due_ + later; }

    // Time from the last look until the next cycle is due; none if it was due.
    Time spare() const noexcept { return spare_; }

 private:
    SourceClock& clock_;
    Time period_;
    Time due_;
    Time spare_{};
};

}  // namespace rsi::hal::zynqmp_r5
