// Force gain: an accelerometer that shows a constant share of the lateral force, or noise in its place.
#pragma once

#include <cstdint>

#include "rsi/ecu/monitoring/lateral_forces.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// Turn by turn it is held against the interval between its two references. A load lets the body roll further
// and so moves one of them alone; a curve that leans inwards moves the other alone, because accelerometer and
// body feel the same force along the road; an offset of a sensor helps in turns to one side and hinders in
// those to the other. Only an accelerometer that is wrong by a factor is outside of the interval in turns to
// both sides. The less it is outside, the longer that has to last: over 4.5 h of ordinary driving of 54 drawn
// vehicles, half of them laden, most on hilly and rough roads, with the roll stiffness up to 10 % wrong, the
// sums of good sensors came to 0.17 m/s. More than load and slide together explain needs no second turn: over
// 10,000 drawn runs at the limit good sensors were never beyond it, over 2,000 with a load that the
// calibration does not know once.
class ForceGain {
 public:
    // One sample. `tipping`: the inner wheels may be in the air, where the body rolls without a force.
    void update(const LateralForces& forces, bool tipping) noexcept {
        const bool left = forces.by_yaw_mps2 > 0.0F;
        const float to_side = left ? 1.0F : -1.0F;
        const float by_yaw = to_side * forces.by_yaw_mps2;
        const float by_roll = to_side * forces.by_roll_mps2;
        const float now = to_side * forces.shown_mps2;
        const float soon = to_side * forces.shown_soon_mps2;
        const float at_most = rsi::larger(now, soon);
        const float at_least = rsi::smaller(now, soon);
        const float least = rsi::smaller(by_yaw, by_roll);
        const float most = rsi::larger(by_yaw, by_roll);
        if (least < clear_mps2) {
            go_straight(forces);
            return;
        }
        if (!tipping) {
            const bool clearly = (least - at_most > clearly_mps2) && (at_most < 0.58F * least);
            weak_.take(left, 0.75F * least - at_most, clearly);
        }
        const bool clearly = (at_least - most > clearly_mps2) && (at_least > 1.8F * most);
        strong_.take(left, at_least - 1.6F * most, clearly);
    }

    // From then on until turns to one side have been right again, or on probation after a calm while.
    bool is_wrong() const noexcept { return weak_.is_enough() || strong_.is_enough(); }

 private:
    // Below this, the sensors' offsets are what is seen.
    static constexpr float clear_mps2 = 1.0F;
    static constexpr float clearly_mps2 = 1.5F;
    static constexpr std::uint32_t calm_samples = 800U;

    // Without a turn a factor cannot be seen, nor that it is gone; noise can, by now. An accelerometer that
    // has been calm for so long is accepted until the next turn.
    void go_straight(const LateralForces& forces) noexcept {
        if (rsi::is_within_magnitude(forces.by_yaw_mps2, clear_mps2)) {
            const bool calm = rsi::is_within_magnitude(forces.shown_mps2, clear_mps2);
            calm_samples_ = (calm && is_wrong()) ? calm_samples_ + 1U : 0U;
        }
        if (calm_samples_ >= calm_samples) {
            weak_.put_on_probation();
            strong_.put_on_probation();
            calm_samples_ = 0U;
        }
    }

    // Against the accelerometer, from turns to each side: by how much it was outside, times how long.
    class Evidence {
     public:
        void take(bool left, float outside_mps2, bool clearly) noexcept {
            float& sum_mps = left ? left_mps_ : right_mps_;
            sum_mps = rsi::clamp(sum_mps + rsi::sample_time_s * outside_mps2, 0.0F, most_mps);
            clear_samples_ = clearly ? clear_samples_ + 1U : 0U;
            if (clear_samples_ >= enough_clear_samples) {
                left_mps_ = most_mps;
                right_mps_ = most_mps;
                clear_samples_ = 0U;
            }
            const float lesser_mps = rsi::smaller(left_mps_, right_mps_);
            enough_ = (lesser_mps > enough_mps) || (enough_ && (lesser_mps > 0.0F));
        }

        bool is_enough() const noexcept { return enough_; }

        // The next that is seen is enough.
        void put_on_probation() noexcept {
            if (enough_) {
                left_mps_ = enough_mps;
                right_mps_ = enough_mps;
                enough_ = false;
            }
        }

     private:
        static constexpr float enough_mps = 0.4F;
        static constexpr float most_mps = 0.5F;  // the yaw rate's lead takes some back as a turn ends
        static constexpr std::uint32_t enough_clear_samples = 5U;

        float left_mps_{0.0F};
        float right_mps_{0.0F};
        std::uint32_t clear_samples_{0U};  // in a row
        bool enough_{false};
    };

    Evidence weak_{};
    Evidence strong_{};
    std::uint32_t calm_samples_{0U};  // on straights, since it is wrong
};

}  // namespace rsi::monitoring
