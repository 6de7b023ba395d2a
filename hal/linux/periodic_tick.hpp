// Periodic tick: wakes its caller at equal distances on an absolute clock, and keeps account of its
// punctuality.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/hal/clock.hpp"
#include "rsi/hal/saturating_count.hpp"

namespace rsi::hal {

// Median, percentiles and largest of many durations in a fixed amount of memory: 4000 bins of 5 us, 0 to 20
// ms, and one for everything beyond; 32 KB. Negative durations count as zero.
class DurationHistogram {
 public:
    static constexpr Time bin_width{5'000};
    static constexpr std::size_t bin_count{4000U};

    void record(Time duration) noexcept {
        const std::int64_t length = duration.nanoseconds < 0 ? 0 : duration.nanoseconds;
        const auto bin = static_cast<std::size_t>(length / bin_width.nanoseconds);
        ++bins_[bin < bin_count ? bin : bin_count];
        ++count_;
        largest_ = largest_ < Time{length} ? Time{length} : largest_;
    }

    std::uint64_t count() const noexcept { return count_; }

    // Exact; zero when nothing was recorded.
    Time largest() const noexcept { return largest_; }

    // The smallest bin edge that at least `share` (0 to 1) of the durations do not reach beyond: 0.5 for the
    // median, 0.99 for the 99th percentile. Never below the true value, nor more than one bin above it, and
    // never above the largest; the largest itself where the share lies beyond 20 ms. Zero when nothing was
    // recorded.
    Time quantile(double share) const noexcept {
        std::uint64_t seen = 0U;
        for (std::size_t bin = 0U; bin < bin_count; ++bin) {
            seen += bins_[bin];
            if (seen > 0U && static_cast<double>(seen) >= share * static_cast<double>(count_)) {
                const Time edge{static_cast<std::int64_t>(bin + 1U) * bin_width.nanoseconds};
                return largest_ < edge ? largest_ : edge;
            }
        }
        return largest_;
    }

 private:
    std::array<std::uint64_t, bin_count + 1U> bins_{};
    std::uint64_t count_{0U};
    Time largest_{};
};

// `Timer` has `Time now() const` and `void wait_until(Time) const`; SteadyClock is one. It must outlive the
// tick. The deadlines are start + 1, 2, 3, ... periods, whatever happens in between but shift(): a
// late tick does not shift later ones, and a deadline that passed together with the one after it is missed,
// not made up for.
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

    // Moves all deadlines to come; `later` below zero: earlier.
    void shift(Time later) noexcept { deadline_ = deadline_ + later; }

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
