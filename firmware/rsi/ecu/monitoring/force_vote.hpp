// Force vote: three independent estimates of the lateral force - the accelerometer, yaw rate times speed, and
// the roll motion, which the body makes under that force. Is the accelerometer alone?
#pragma once

#include "rsi/adaptation/load_bounds.hpp"
#include "rsi/ecu/monitoring/driving_speed.hpp"
#include "rsi/ecu/monitoring/lateral_forces.hpp"
#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// A bank of the road or a slide separates the yaw rate from the other two, a wrong roll angle separates
// itself; only a wrong lateral acceleration contradicts both. The roll angle alone would be a reference for
// a car, not for a truck, whose body swings long after its tyres: hence the whole roll equation, at the
// centre of gravity.
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
        if (rsi::is_within(used, rsi::least_load_excess, rsi::largest_load_excess)) {
            held_share_ = 1.0F / (1.0F + used);
        }
    }

    // One sample, and the roll angle against the road; one that is not finite, or of a body far over, starts
    // anew. `forward`: the yaw rate has the sign of the turn.
    void update(const rsi::Inputs& inputs, float roll_angle_rad, bool forward) noexcept {
        // At the IMU turning adds to the force, and rolling needs a force for the inertia: both are a
        // rate of change, which through the lag is what the lag has yet to follow, over its time.
        const float imu = (imu_x_m_ * inputs.yaw_rate_radps - imu_z_m_ * inputs.roll_rate_radps) / lag_s;
        const float inertia = (force_per_acceleration_m_ / lag_s) * inputs.roll_rate_radps;
        const float damping = force_per_rate_mps_ * inputs.roll_rate_radps;
        const float held = force_per_angle_mps2_ * roll_angle_rad + damping;
        // The dampers feel the body's rate against the road: that of the angle. The roll rate has the bank's
        // as well, which a road that twists makes as large as that.
        const float road_damping = (force_per_rate_mps_ / lag_s) * roll_angle_rad;
        const float turn = inputs.yaw_rate_radps * inputs.speed_mps;
        const float by_yaw = force_by_yaw(turn, inputs, forward);
        const bool knew = known_;
        known_ = rsi::is_within_magnitude(roll_angle_rad, 0.15F) &&
                 rsi::is_finite(inputs.lateral_specific_force_mps2 + turn + imu + held);
        if (!known_) {
            return;
        }
        if (!knew) {  // no contradiction yet
            shown_ = by_yaw + imu;
            by_yaw_ = by_yaw;
            held_ = by_yaw;
            inertia_ = inertia;
            by_bank_ = road_damping;
        }
        const float ahead = (latest_s / lag_s) * (inputs.lateral_specific_force_mps2 + imu - shown_);
        follow(inputs.lateral_specific_force_mps2 + imu, shown_);
        follow(by_yaw, by_yaw_);
        follow(held, held_);
        follow(inertia, inertia_);
        follow(damping + road_damping, by_bank_);
        const float shown = shown_ - imu;
        const float rolling = inertia - inertia_;
        forces_ = LateralForces{shown, shown + ahead, by_yaw_, held_share_ * held_ + rolling};
        against_yaw_mps2_ = forces_.shown_mps2 - forces_.by_yaw_mps2;
        against_roll_mps2_ = forces_.shown_mps2 - forces_.by_roll_mps2;
        // The roll sensor may itself have taught the load.
        const float excused_share = rsi::clamp(held_share_, 1.0F / (1.0F + rsi::largest_taught_load), 1.0F);
        against_road_mps2_ = shown - rolling - excused_share * (held_ - (by_bank_ - road_damping));
    }

    // Whether the last sample was one; then the three forces.
    bool known() const noexcept { return known_; }
    const LateralForces& forces() const noexcept { return forces_; }
    // Excess of the accelerometer over the force that rolls the body.
    float beyond_roll_mps2() const noexcept { return against_roll_mps2_; }

    bool accelerometer_is_alone() const noexcept {
        const float least = lesser_contradiction_mps2();
        return (least > 3.0F) && (rsi::absolute(against_roll_mps2_ - against_yaw_mps2_) < 0.5F * least);
    }
    // Half of that, however the others agree.
    bool accelerometer_is_suspect() const noexcept { return lesser_contradiction_mps2() > 1.5F; }
    // Half of what counts as a contradiction: the yaw rate alone may be ahead in a weave.
    bool roll_motion_agrees() const noexcept {
        return known_ && rsi::is_within_magnitude(against_road_mps2_, 1.5F);
    }

 private:
    static constexpr float lag_s = 0.3F;
    static constexpr float latest_s = 0.08F;

    // Either one may be right for a vehicle that may be going backwards.
    static float force_by_yaw(float turn_mps2, const rsi::Inputs& inputs, bool forward) noexcept {
        return (forward && (inputs.speed_mps > driving_speed_mps))
                   ? turn_mps2
                   : rsi::clamp_magnitude(inputs.lateral_specific_force_mps2, rsi::absolute(turn_mps2));
    }

    // 0 if unknown, or if they contradict it on different sides.
    float lesser_contradiction_mps2() const noexcept {
        const bool same_side = known_ && (against_yaw_mps2_ * against_roll_mps2_ > 0.0F);
        return same_side ? rsi::smaller(rsi::absolute(against_yaw_mps2_), rsi::absolute(against_roll_mps2_))
                         : 0.0F;
    }

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
    float shown_{0.0F};  // with what makes a rate of change of it
    float by_yaw_{0.0F};
    float held_{0.0F};
    float inertia_{0.0F};
    float by_bank_{0.0F};  // damping by the roll rate, and by the angle less what the lag has followed
    LateralForces forces_{};
    float against_yaw_mps2_{0.0F};
    float against_roll_mps2_{0.0F};
    float against_road_mps2_{0.0F};  // damped against the road
};

}  // namespace rsi::monitoring
