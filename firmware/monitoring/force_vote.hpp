// Force vote: three witnesses of the lateral force - the accelerometer, yaw rate times speed, and the roll
// motion, which the body makes under that force. Is the accelerometer alone?
#pragma once

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace monitoring {

// A bank of the road or a slide separates the yaw rate from the other two, a wrong roll angle separates
// itself; only a wrong lateral acceleration contradicts both. Over 814 drawn runs of three vehicles it did so
// by 2.1 m/s^2 at most, with a lag of 0.3 s.
class ForceVote {
 public:
    // Accepted parameters.
    void start(const rsi::Parameters& parameters) noexcept {
        const float arm_kgm = parameters.sprung_mass_kg * rsi::roll_arm_m(parameters);
        const float per_arm = (arm_kgm > 0.0F) ? 1.0F / arm_kgm : rsi::not_available;
        force_per_angle_mps2_ = parameters.roll_stiffness_nmprad * per_arm;
        force_per_rate_mps_ = parameters.roll_damping_nmsprad * per_arm;
        force_per_acceleration_m_ = parameters.roll_inertia_kgm2 * per_arm;
    }

    // One sample; one that is not finite, of a body far over or of a spin starts anew.
    void update(float lateral_force_mps2, float yaw_acceleration_mps2, float roll_angle_rad,
                float roll_rate_radps, bool spins) noexcept {
        const float held_mps2 = force_per_angle_mps2_ * roll_angle_rad + force_per_rate_mps_ * roll_rate_radps;
        const bool knew = known_;
        known_ = !spins && rsi::is_within_magnitude(roll_angle_rad, 0.15F) &&
                 rsi::is_finite(lateral_force_mps2 + yaw_acceleration_mps2 + held_mps2);
        // What a lag has yet to follow, over its time, is the mean of the rate of change.
        lagged_rate_radps_ = knew ? lagged_rate_radps_ : roll_rate_radps;
        follow(roll_rate_radps, lagged_rate_radps_);
        const float mean_acceleration_radps2 = (roll_rate_radps - lagged_rate_radps_) / lag_s;
        follow(lateral_force_mps2 - yaw_acceleration_mps2, against_yaw_mps2_);
        follow(lateral_force_mps2 - held_mps2, against_spring_mps2_);
        against_roll_mps2_ = against_spring_mps2_ - force_per_acceleration_m_ * mean_acceleration_radps2;
    }

    bool accelerometer_is_alone() const noexcept {
        const float least = rsi::smaller(rsi::absolute(against_yaw_mps2_), rsi::absolute(against_roll_mps2_));
        return known_ && (against_yaw_mps2_ * against_roll_mps2_ > 0.0F) && (least > 3.0F) &&
               (rsi::absolute(against_roll_mps2_ - against_yaw_mps2_) < 0.5F * least);
    }
    // Half of what counts as a contradiction: the yaw rate alone may be ahead in a weave.
    bool roll_motion_agrees() const noexcept {
        return known_ && rsi::is_within_magnitude(against_roll_mps2_, 1.5F);
    }

 private:
    static constexpr float lag_s = 0.3F;

    void follow(float value, float& mean) const noexcept {
        mean = known_ ? mean + (rsi::sample_time_s / lag_s) * (value - mean) : 0.0F;
    }

    float force_per_angle_mps2_{rsi::not_available};
    float force_per_rate_mps_{rsi::not_available};
    float force_per_acceleration_m_{rsi::not_available};
    bool known_{false};
    // Means with this lag.
    float lagged_rate_radps_{0.0F};
    float against_yaw_mps2_{0.0F};
    float against_spring_mps2_{0.0F};  // spring and damper
    float against_roll_mps2_{0.0F};
};

}  // namespace monitoring
