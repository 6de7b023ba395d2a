// Lateral response: how the force along the road goes on when the steering stays as it is.
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/prediction/steering_demand.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The force and its rate in the course of time.
struct ForceCourse {
    float force_mps2{0.0F};
    float rate_mps3{0.0F};
};

// Target of the force.
struct ForceTarget {
    float force_mps2;  // a_t
    // The force goes neither past it nor past where it is, but may fall to zero.
    float least_mps2;
    float most_mps2;
};

// The vehicle as a second-order system between the steering and the force A along the road,
//   A'' = w^2 (a_t - A) - 2 zeta w A',
// with a_t the demand of the steering within what the tyres give.
class LateralResponse {
 public:
    // Seconds between two points of a course; half of it costs twice as much and warns no earlier.
    static constexpr float step_s = 0.04F;

    LateralResponse() = default;
    [[gnu::cold]] explicit LateralResponse(const Parameters& parameters);

    bool is_known() const { return is_known_; }
    float largest_mps2() const { return largest_mps2_; }  // that the tyres give

    // Target of the motion: A + lead A'.
    float tended_mps2(const RollMotion& motion) const {
        return motion.road_parallel_force_mps2 + lead_s_ * motion.road_parallel_force_rate_mps3;
    }

    // The force after one more step.
    ForceCourse after_step(const ForceCourse& from, const ForceTarget& target) const;

 private:
    bool is_known_{false};
    float largest_mps2_{};
    float lead_s_{};  // 2 zeta / w
    // One step on (A - a_t, A').
    float force_by_force_{};
    float force_by_rate_{};
    float rate_by_force_{};
    float rate_by_rate_{};
};

// The limit of the tyres, learnt: it falls to the force that the vehicle keeps to while the steering asks for
// more, and comes back in seconds to the calibrated one.
class TyreLimit {
 public:
    void reset(const LateralResponse& response) { limit_mps2_ = response.largest_mps2(); }

    // One sample: learns the limit. False where the course is not known: without steering, speed, or a
    // calibrated response; else `target` is where the force is going.
    bool update(const LateralResponse& response, const RollMotion& motion, const DemandedForce& demand,
                ForceTarget& target);

 private:
    float limit_mps2_{};
};

}  // namespace rsi
