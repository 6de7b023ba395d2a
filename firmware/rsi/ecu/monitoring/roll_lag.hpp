// Roll lag: how far the roll angle is behind the roll rate in time.
#pragma once

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// An angle that is late by tau differs from the integrated roll rate by -tau times the roll rate. The slow
// part (a bank, an offset) is taken off both, and tau is fitted by least squares. That needs a body that has
// rolled to and fro: at a sum of 1 rad^2/s^2, a second at 0.1 rad/s, a roll sensor's noise of 0.2 deg is
// worth 4 ms.
class RollLag {
 public:
    // One sample; one that is not finite starts anew.
    void update(float roll_angle_rad, float roll_rate_radps) noexcept {
        const float turned = rsi::sample_time_s * roll_rate_radps;
        const float apart = quick_share * (apart_rad_ + (roll_angle_rad - angle_rad_) - turned);
        const float rate = quick_share * (quick_radps_ + (roll_rate_radps - rate_radps_));
        const bool known = rsi::is_finite(apart) && rsi::is_finite(rate);  // the first one is not
        angle_rad_ = roll_angle_rad;
        rate_radps_ = roll_rate_radps;
        apart_rad_ = known ? apart : 0.0F;
        quick_radps_ = known ? rate : 0.0F;
        moved_ = known ? moved_ + rate * rate : 0.0F;
        lagged_ = known ? lagged_ - rate * apart : 0.0F;
        if (moved_ > 2.0F) {  // older samples count less: an angle may once have jumped
            moved_ *= 0.5F;
            lagged_ *= 0.5F;
        }
    }

    // It has moved enough, and is not behind by as much as makes a value too old.
    bool angle_is_in_time() const noexcept { return (moved_ > 1.0F) && (lagged_ < 0.035F * moved_); }
    // The same of the rate.
    bool rate_is_in_time() const noexcept { return (moved_ > 1.0F) && (lagged_ > -0.035F * moved_); }

 private:
    static constexpr float quick_share = 0.3F / (0.3F + rsi::sample_time_s);  // high-pass of 0.3 s

    float angle_rad_{rsi::not_available};  // of the sample before
    float rate_radps_{0.0F};
    float apart_rad_{0.0F};
    float quick_radps_{0.0F};
    float moved_{0.0F};   // rad^2/s^2
    float lagged_{0.0F};  // tau times the same
};

}  // namespace rsi::monitoring
