// Clock check: detects a platform clock that jumps.
#pragma once

#include <cstdint>

namespace rsi::monitoring {

class ClockCheck {
 public:
    // One cycle. `missed_cycles`: number of cycles missed before it. True when the clock went back, or
    // forward by 0.25 s more than the cycles explain; the tolerance leaves a late cycle to the code
    // cycle_overrun.
    bool has_jumped(std::int64_t now_ns, std::uint32_t missed_cycles) noexcept {
        const std::int64_t expected = cycle_ns * (std::int64_t{missed_cycles} + 1);
        const bool jumped =
            started_ && ((now_ns < last_ns_) || (now_ns - last_ns_ > expected + tolerance_ns));
        last_ns_ = now_ns;
        started_ = true;
        return jumped;
    }

 private:
    static constexpr std::int64_t cycle_ns = 10'000'000;
    static constexpr std::int64_t tolerance_ns = 250'000'000;

    std::int64_t last_ns_{0};
    bool started_{false};
};

}  // namespace rsi::monitoring
