// Vertical offset: the vertical specific force of a body that neither rises nor falls is known.
#pragma once

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// f_z = g cos(roll) - a_y sin(roll), nearly g - f_y roll, plus the heave, whose mean over a second is small.
// Over 814 drawn runs of three vehicles the difference with a lag of 0.4 s came to 1.25 m/s^2 before a
// warning and to 2.4 in one, where wheels lift and come down.
class VerticalOffset {
 public:
    // One sample; one that is not finite, or of a body far over, starts anew. `bank_rad`: of the road, left
    // side up; one that leans into the turn presses the body down. As it is known roughly and late, any part
    // of that will do.
    void update(float vertical_force_mps2, float lateral_force_mps2, float roll_angle_rad, float turn_mps2,
                float bank_rad) noexcept {
        const float beyond_gravity = vertical_force_mps2 - rsi::gravity_mps2;
        const float level = -lateral_force_mps2 * roll_angle_rad;
        const float pressed = rsi::larger(level - turn_mps2 * bank_rad, level);
        const float difference = beyond_gravity - rsi::clamp(beyond_gravity, level, pressed);
        known_ = rsi::is_finite(difference) && rsi::is_within_magnitude(roll_angle_rad, 0.2F) &&
                 rsi::is_within_magnitude(lateral_force_mps2, 11.0F);
        mean_mps2_ = known_ ? mean_mps2_ + (rsi::sample_time_s / 0.4F) * (difference - mean_mps2_) : 0.0F;
    }

    bool is_within() const noexcept { return known_ && rsi::is_within_magnitude(mean_mps2_, bound_mps2); }
    // `may_lift`: wheels may lift and come down. Between the two bounds neither is shown then.
    bool is_beyond(bool may_lift) const noexcept {
        return known_ && !rsi::is_within_magnitude(mean_mps2_, may_lift ? lifting_bound_mps2 : bound_mps2);
    }

 private:
    static constexpr float bound_mps2 = 1.5F;
    static constexpr float lifting_bound_mps2 = 3.5F;

    bool known_{false};
    float mean_mps2_{0.0F};
};

}  // namespace rsi::monitoring
