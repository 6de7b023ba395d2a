// Duration histogram: median, percentiles and largest of many durations in a fixed amount of memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/hal/clock.hpp"

namespace rsi::hal {

// 4000 bins of 5 us, so 0 to 20 ms, and one for everything beyond; 32 KB. Negative durations count as zero.
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

}  // namespace rsi::hal
