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

// The vehicle as a second-order system between the steering and the force A along the road,
//   A'' = w^2 (a_t - A) - 2 zeta w A',
// with a_t the demand of the steering within what the tyres give. That limit is learnt: it falls to the force
// that the vehicle keeps to while the steering asks for more, and comes back in seconds.
class LateralResponse {
 public:
    // Seconds between two points of a course; half of it costs twice as much and warns no earlier.
    static constexpr float step_s = 0.04F;

    [[gnu::cold]] void init(const Parameters& parameters) {
        tune(parameters);
        reset();
    }

    // The parameters from now on; the learnt limit goes to the new one's by itself.
    [[gnu::cold]] void tune(const Parameters& parameters);

    void reset() { limit_mps2_ = largest_mps2_; }

    // One sample: learns the limit. False where the course is not known: without steering, speed, or a
    // calibrated response.
    bool update(const RollMotion& motion, const DemandedForce& demand);

    // The force after one more step.
    ForceCourse after_step(const ForceCourse& from) const;

 private:
    bool is_known_{false};
    float lead_s_{0.0F};  // 2 zeta / w: A + lead A' is what the motion is tending to
    float largest_mps2_{1.0F};
    float limit_mps2_{1.0F};
    float target_mps2_{0.0F};  // a_t
    // The force goes neither past it nor past where it is, but may fall to zero.
    float least_mps2_{0.0F};
    float most_mps2_{0.0F};
    // One step on (A - a_t, A').
    float force_by_force_{1.0F};
    float force_by_rate_{0.0F};
    float rate_by_force_{0.0F};
    float rate_by_rate_{1.0F};
};

}  // namespace rsi
