// Judges the counters of undamaged frames as they arrive; every profile with a counter uses it.
#pragma once

#include <cstdint>

#include "rsi/can_dbc/e2e/check_status.hpp"

namespace rsi::can_dbc::e2e {

// `range`: how many values the counter takes before it starts again at 0.
//
// The first frame is ok: nothing is known to be lost before it. Every frame becomes the reference of the next
// one, whatever its status, so that a jump of the counter costs one frame and never locks the receiver.
template <unsigned range>
class CounterSequence {
    static_assert(range >= 2U && range <= 256U, "the counter has to fit into a byte");

 public:
    // `largest_step` is how far the counter may advance between two frames, 1 to range - 1: 1 tolerates no
    // lost frame.
    constexpr explicit CounterSequence(std::uint8_t largest_step) : largest_step_{largest_step} {}

    // `counter` is 0 to range - 1.
    constexpr CheckResult follow(std::uint8_t counter) {
        const unsigned step = (counter + range - counter_) % range;
        const bool first = !has_reference_;
        has_reference_ = true;
        counter_ = counter;
        if (first || step == 1U) {
            return CheckResult{CheckStatus::ok};
        }
        if (step == 0U) {
            return CheckResult{CheckStatus::repeated};
        }
        const CheckStatus status =
            step <= largest_step_ ? CheckStatus::ok_some_lost : CheckStatus::wrong_sequence;
        return CheckResult{status, CheckError::none, static_cast<std::uint8_t>(step - 1U)};
    }

 private:
    std::uint8_t largest_step_;
    std::uint8_t counter_{0U};
    bool has_reference_{false};
};

}  // namespace rsi::can_dbc::e2e
