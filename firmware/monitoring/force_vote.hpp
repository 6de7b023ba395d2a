// Force vote: three witnesses of the lateral force - the accelerometer, yaw rate times speed, and the roll
// motion, which the body makes under that force. Is the accelerometer alone?
#pragma once

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace monitoring {

// A bank of the road or a slide separates the yaw rate from the other two, a wrong roll angle separates
// itself; only a wrong lateral acceleration contradicts both. The roll angle alone would be a witness of a
// car, not of a truck, whose body swings long after its tyres: hence the whole roll equation, at the centre
// of gravity.
class ForceVote {
 public:
    // Accepted parameters.
    void start(const rsi::Parameters& parameters) noexcept {
        const float arm_kgm = parameters.sprung_mass_kg * rsi::roll_arm_m(parameters);
        const float per_arm = (arm_kgm > 0.0F) ? 1.0F / arm_kgm : rsi::not_available;
        force_per_angle_mps2_ = parameters.roll_stiffness_nmprad * per_arm;
        force_per_rate_mps_ = parameters.roll_damping_nmsprad * per_arm;
        force_per_acceleration_m_ = parameters.roll_inertia_kgm2 * per_arm;
        used_load_share_ = parameters.load_adaptation;
        imu_x_m_ = parameters.imu_x_m;
        imu_z_m_ = parameters.imu_z_m;
    }

    // `excess`: by which share m_s H is larger than calibrated, as driving has shown; used as far as the
    // calibration wants. The same force rolls such a body further, at the same acceleration, since its
    // inertia grows as well. Not available while the component makes no statement: then it stays, or else a
    // vote that has led there would go on.
    void assume_load(float excess) noexcept {
        const float used = used_load_share_ * excess;
        if (rsi::is_within(used, -0.5F, 1.5F)) {
            held_share_ = 1.0F / (1.0F + used);
        }
    }

    // One sample; one that is not finite, of a body far over or of a vehicle that stands or spins starts
    // anew.
    void update(const rsi::Inputs& inputs, bool rolls_on) noexcept {
        const float yaw_mps2 = inputs.yaw_rate_radps * inputs.speed_mps;
        const float imu_mps = imu_x_m_ * inputs.yaw_rate_radps - imu_z_m_ * inputs.roll_rate_radps;
        const float held_mps2 = held_share_ * (force_per_angle_mps2_ * inputs.roll_angle_rad +
                                               force_per_rate_mps_ * inputs.roll_rate_radps);
        const bool knew = known_;
        known_ = rolls_on && rsi::is_within_magnitude(inputs.roll_angle_rad, 0.15F) &&
                 rsi::is_finite(inputs.lateral_specific_force_mps2 + yaw_mps2 + imu_mps + held_mps2);
        if (!known_) {
            return;
        }
        if (!knew) {
            imu_mps_ = imu_mps;
            roll_rate_radps_ = inputs.roll_rate_radps;
            less_yaw_mps2_ = 0.0F;
            less_held_mps2_ = 0.0F;
        }
        follow(imu_mps, imu_mps_);
        follow(inputs.roll_rate_radps, roll_rate_radps_);
        follow(inputs.lateral_specific_force_mps2 - yaw_mps2, less_yaw_mps2_);
        follow(inputs.lateral_specific_force_mps2 - held_mps2, less_held_mps2_);
        // What a lag has yet to follow, over its time, is the mean of the rate of change: here, what the
        // IMU's place adds to the force at the centre of gravity, and the roll acceleration.
        const float imu_mps2 = (imu_mps - imu_mps_) / lag_s;
        const float roll_radps2 = (inputs.roll_rate_radps - roll_rate_radps_) / lag_s;
        against_yaw_mps2_ = less_yaw_mps2_ - imu_mps2;
        against_roll_mps2_ = less_held_mps2_ - imu_mps2 - force_per_acceleration_m_ * roll_radps2;
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

    static void follow(float value, float& mean) noexcept {
        mean += (rsi::sample_time_s / lag_s) * (value - mean);
    }

    float force_per_angle_mps2_{rsi::not_available};
    float force_per_rate_mps_{rsi::not_available};
    float force_per_acceleration_m_{rsi::not_available};
    float used_load_share_{0.0F};
    float held_share_{1.0F};  // of the force that would roll the calibrated body as far
    float imu_x_m_{0.0F};
    float imu_z_m_{0.0F};
    bool known_{false};
    // Means with this lag.
    float imu_mps_{0.0F};
    float roll_rate_radps_{0.0F};
    float less_yaw_mps2_{0.0F};
    float less_held_mps2_{0.0F};
    float against_yaw_mps2_{0.0F};
    float against_roll_mps2_{0.0F};
};

}  // namespace monitoring
