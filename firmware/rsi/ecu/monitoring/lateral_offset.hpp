// Lateral offset: what the lateral accelerometer shows too much to one side, over minutes of driving.
#pragma once

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// Straight on for minutes, neither a slide nor a turn is left of what the accelerometer shows beyond yaw rate
// times speed: only the road's bank, the yaw rate's own offset, and that of the accelerometer, as of a
// housing that is mounted askew. A bank rolls the body by as much as the accelerometer shows, an offset does
// not; a wrong zero of the roll angle, a load on one side and a wind from the side turn no vehicle. Only what
// both references miss on the same side is the accelerometer's.
class LateralOffset {
 public:
    // Whether such a turn (yaw rate times speed) is straight enough to learn from.
    static constexpr bool learns_at(float turn_mps2) noexcept {
        return rsi::is_within_magnitude(turn_mps2, straight_mps2);
    }

    // One sample: what the accelerometer, corrected, shows beyond yaw rate times speed, and beyond the force
    // that rolls the body. One that is not finite, or too large for an offset, teaches nothing.
    void update(float beyond_yaw_mps2, float beyond_roll_mps2) noexcept {
        const float by_yaw = beyond_yaw_mps2 + correction_mps2_;
        const float by_roll = beyond_roll_mps2 + correction_mps2_;
        if (rsi::is_within_magnitude(by_yaw, largest_mps2) &&
            rsi::is_within_magnitude(by_roll, largest_mps2)) {
            by_yaw_mps2_ += (rsi::sample_time_s / lag_s) * (by_yaw - by_yaw_mps2_);
            by_roll_mps2_ += (rsi::sample_time_s / lag_s) * (by_roll - by_roll_mps2_);
            decide();
        }
    }

    // To be subtracted from what the accelerometer shows.
    float correction_mps2() const noexcept { return correction_mps2_; }
    // More than a mounting or an ageing sensor explains: none of its values is to be used.
    bool is_beyond() const noexcept { return is_beyond_; }

    // Offset that the next trip is to start from; 0 while nothing is corrected.
    float learnt_mps2() const noexcept { return learnt_mps2_; }
    // False, with nothing restored, for a value out of range.
    [[gnu::cold]] bool restore(float learnt_mps2) noexcept {
        const bool good = rsi::is_within_magnitude(learnt_mps2, largest_mps2);
        if (good) {
            by_yaw_mps2_ = learnt_mps2;
            by_roll_mps2_ = learnt_mps2;
            decide();
        }
        return good;
    }

 private:
    static constexpr float lag_s = 120.0F;
    static constexpr float straight_mps2 = 1.5F;
    static constexpr float largest_mps2 = 3.0F;
    // A road that is crowned by 3 % for hours shows 0.35 m/s^2, the body's own roll with it; a yaw rate that
    // is 0.5 deg/s off at 30 m/s shows 0.26 m/s^2, a roll angle that is 0.3 deg off as much.
    static constexpr float tolerance_mps2 = 0.4F;
    static constexpr float beyond_mps2 = 1.2F;
    static constexpr float within_mps2 = 1.0F;

    // Nothing up to the tolerance, and all of it from twice that on; no step between.
    void decide() noexcept {
        const float side = (by_yaw_mps2_ > 0.0F) ? 1.0F : -1.0F;
        const float size = rsi::smaller(side * by_yaw_mps2_, side * by_roll_mps2_);
        if (!(size > tolerance_mps2)) {
            learnt_mps2_ = 0.0F;
            correction_mps2_ = 0.0F;
            is_beyond_ = false;
            return;
        }
        const float corrected = rsi::smaller(size, 2.0F * (size - tolerance_mps2));
        learnt_mps2_ = side * size;
        correction_mps2_ = side * rsi::smaller(corrected, beyond_mps2);
        is_beyond_ = size > (is_beyond_ ? within_mps2 : beyond_mps2);
    }

    float by_yaw_mps2_{0.0F};  // means
    float by_roll_mps2_{0.0F};
    float learnt_mps2_{0.0F};
    float correction_mps2_{0.0F};
    bool is_beyond_{false};
};

}  // namespace rsi::monitoring
