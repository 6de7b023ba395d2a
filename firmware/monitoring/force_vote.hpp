// Force vote: three witnesses of the lateral force - the accelerometer, yaw rate times speed, and the roll
// angle, which the suspension takes under that force. Is the accelerometer alone?
#pragma once

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace monitoring {

// A bank of the road or a slide separates the yaw rate from the other two, a wrong roll angle separates itself;
// only a wrong lateral acceleration contradicts both. Over 814 drawn runs of three vehicles it did so by 2.1
// m/s^2 at most, with a lag of 0.3 s.
class ForceVote {
 public:
    // Accepted parameters.
    void start(const rsi::Parameters& parameters) noexcept {
        const float arm_kgm = parameters.sprung_mass_kg * rsi::roll_arm_m(parameters);
        force_per_roll_mps2_ =
            (arm_kgm > 0.0F) ? parameters.roll_stiffness_nmprad / arm_kgm : rsi::not_available;
    }

    // One sample; one that is not finite, of a body far over or of a spin starts anew.
    void update(float lateral_force_mps2, float yaw_acceleration_mps2, float roll_angle_rad,
                bool spins) noexcept {
        const float by_roll_mps2 = force_per_roll_mps2_ * roll_angle_rad;
        known_ = !spins && rsi::is_within_magnitude(roll_angle_rad, 0.15F) &&
                 rsi::is_finite(lateral_force_mps2 + yaw_acceleration_mps2 + by_roll_mps2);
        follow(lateral_force_mps2 - yaw_acceleration_mps2, against_yaw_mps2_);
        follow(lateral_force_mps2 - by_roll_mps2, against_roll_mps2_);
        follow(yaw_acceleration_mps2 - by_roll_mps2, others_mps2_);
    }

    bool accelerometer_is_alone() const noexcept {
        const float least = rsi::smaller(rsi::absolute(against_yaw_mps2_), rsi::absolute(against_roll_mps2_));
        return known_ && (against_yaw_mps2_ * against_roll_mps2_ > 0.0F) && (least > 3.0F) &&
               (rsi::absolute(others_mps2_) < 0.5F * least);
    }
    // Half of what counts as a contradiction: the yaw rate alone may be ahead in a weave.
    bool roll_angle_agrees() const noexcept {
        return known_ && rsi::is_within_magnitude(against_roll_mps2_, 1.5F);
    }

 private:
    void follow(float value, float& mean) const noexcept {
        mean = known_ ? mean + (rsi::sample_time_s / 0.3F) * (value - mean) : 0.0F;
    }

    float force_per_roll_mps2_{rsi::not_available};
    bool known_{false};
    float against_yaw_mps2_{0.0F};
    float against_roll_mps2_{0.0F};
    float others_mps2_{0.0F};
};

}  // namespace monitoring
