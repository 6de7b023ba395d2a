// Roll lag: how far the roll angle is behind the roll rate in time.
#pragma once

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace monitoring {

// An angle that is late by tau differs from the integrated roll rate by -tau times the roll rate. What is slow
// is taken off both (a bank, an offset), and tau is fitted by least squares. That needs a body that has
// rolled to and fro: at a sum of 1 rad^2/s^2, a second at 0.1 rad/s, a roll sensor's noise of 0.2 deg is
// worth 4 ms.
class RollLag {
 public:
    // One sample; one that is not finite starts anew.
    void update(float roll_angle_rad, float roll_rate_radps) noexcept {
        const float turned = turned_rad_ + rsi::sample_time_s * roll_rate_radps;
        const float difference = roll_angle_rad - turned;
        if (!rsi::is_within_magnitude(difference, largest_turn_rad)) {
            *this = RollLag{};
            return;
        }
        turned_rad_ = turned;
        if (!running_) {
            slow_rad_ = difference;
            slow_radps_ = roll_rate_radps;
            running_ = true;
        }
        const float apart = difference - slow_rad_;
        const float rate = roll_rate_radps - slow_radps_;
        slow_rad_ += share * apart;
        slow_radps_ += share * rate;
        moved_ += rate * rate;
        lagged_ -= rate * apart;
    }

    // It has moved enough, and is not behind by as much as makes a value too old.
    bool is_in_time() const noexcept { return (moved_ > 1.0F) && (lagged_ < 0.035F * moved_); }

 private:
    static constexpr float largest_turn_rad = 50.0F;  // keeps the integral's resolution
    static constexpr float share = rsi::sample_time_s / 0.3F;

    bool running_{false};
    float turned_rad_{0.0F};
    float slow_rad_{0.0F};
    float slow_radps_{0.0F};
    float moved_{0.0F};   // rad^2/s^2
    float lagged_{0.0F};  // tau times the same
};

}  // namespace monitoring
