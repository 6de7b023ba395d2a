// Periodic tick: wakes its caller at equal distances on an absolute clock, and keeps account of its
// punctuality.
#pragma once

#include <cstdint>

#include "hal/linux/duration_histogram.hpp"
#include "rsi/hal/clock.hpp"
#include "rsi/hal/saturating_count.hpp"

namespace rsi::hal {

// `Timer` has `Time now() const` and `void wait_until(Time) const`; SteadyClock is one. It must outlive the
// tick. The deadlines are start + 1, 2, 3, ... periods, whatever happens in between: a late tick does not
// shift later ones, and a deadline that passed together with the one after it is missed, not made up for.
template <typename Timer>
class PeriodicTick {
 public:
    // `period` above zero. The first deadline is one period from now.
    PeriodicTick(Timer& timer, Time period) noexcept : timer_(timer), period_(period) { restart(); }

    // Sets the first deadline to one period from now; keeps the account.
    void restart() noexcept { deadline_ = timer_.now() + period_; }

    // Sleeps until the next deadline. Returns the number of whole periods that were missed before this
    // wake-up, 0 when all is well. Call it once a cycle.
    std::uint32_t wait() noexcept {
        if (deadline_ < timer_.now()) {
            count_up(overruns_);
        } else {
            timer_.wait_until(deadline_);
        }
        const Time lateness = timer_.now() - deadline_;
        const std::int64_t missed = lateness.nanoseconds / period_.nanoseconds;
        deadline_ = deadline_ + Time{(missed + 1) * period_.nanoseconds};

        lateness_.record(lateness);
        const std::uint32_t counted =
            missed < most_counted ? static_cast<std::uint32_t>(missed) : most_counted;
        count_up(missed_periods_, counted);
        return counted;
    }

    // Wake-ups so far.
    std::uint64_t ticks() const noexcept { return lateness_.count(); }

    // Cycles whose work was not done when their next deadline passed.
    std::uint32_t overruns() const noexcept { return overruns_; }

    // Sum of what wait() returned: missed deadlines.
    std::uint32_t missed_periods() const noexcept { return missed_periods_; }

    // How long after its deadline each wake-up came.
    const DurationHistogram& lateness() const noexcept { return lateness_; }

 private:
    static constexpr std::uint32_t most_counted{0xFFFF'FFFFU};

    Timer& timer_;
    Time period_;
    Time deadline_{};
    std::uint32_t overruns_{0U};
    std::uint32_t missed_periods_{0U};
    DurationHistogram lateness_;
};

}  // namespace rsi::hal
