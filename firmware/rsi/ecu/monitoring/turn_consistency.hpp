// Turn consistency: lateral acceleration against yaw rate times speed.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/driving_speed.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// f_y - r V = v_y' + g sin(roll + bank): a slide, and the road. In a spin it is as large as the lateral
// acceleration itself and stays so for a second, so short times prove nothing by themselves: the fast filter
// only decides between two suspects. The slow one came to 5.1 m/s^2 at most over 2,900 drawn runs of three
// vehicles, spins among them.
class TurnConsistency {
 public:
    // One sample; one that is not finite, or from a vehicle that hardly moves or may go backwards, starts
    // anew.
    void update(float lateral_force_mps2, float yaw_rate_radps, float speed_mps, bool forward) noexcept {
        const float difference = lateral_force_mps2 - yaw_rate_radps * speed_mps;
        difference_mps2_ = difference;
        known_ = rsi::is_finite(difference) && (speed_mps > driving_speed_mps) && forward;
        const bool spins = known_ && !rsi::is_within_magnitude(yaw_rate_radps * speed_mps, tyres_give_mps2);
        const std::uint32_t fewer = (after_spin_ > 0U) ? after_spin_ - 1U : 0U;
        after_spin_ = spins ? spin_samples : fewer;
        if (!known_) {
            fast_mps2_ = 0.0F;
            slow_mps2_ = 0.0F;
            return;
        }
        fast_mps2_ += (rsi::sample_time_s / 0.3F) * (difference - fast_mps2_);
        slow_mps2_ += (rsi::sample_time_s / 4.0F) * (difference - slow_mps2_);
    }

    bool known() const noexcept { return known_; }
    // It yaws faster than tyres can turn it, or did within the last second: no time for the observer, whose
    // tyres roll.
    bool spins() const noexcept { return after_spin_ > 0U; }
    // More than most roads' bank explains (15 %: 1.5 m/s^2): rather no statement than a wrong one.
    bool suspicious() const noexcept { return known_ && !rsi::is_within_magnitude(fast_mps2_, 1.5F); }
    // More than any slide explains.
    bool contradicts() const noexcept { return known_ && !rsi::is_within_magnitude(slow_mps2_, 7.0F); }
    // However slow the vehicle is.
    bool agrees() const noexcept { return rsi::is_within_magnitude(difference_mps2_, 2.0F); }

 private:
    static constexpr float tyres_give_mps2 = 10.5F;
    static constexpr std::uint32_t spin_samples = 100U;

    bool known_{false};
    float difference_mps2_{rsi::not_available};
    float fast_mps2_{0.0F};  // lag 0.3 s
    float slow_mps2_{0.0F};  // lag 4 s
    std::uint32_t after_spin_{0U};
};

}  // namespace rsi::monitoring
