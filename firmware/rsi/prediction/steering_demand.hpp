// Steering demand: the lateral acceleration that the steering asks for.
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Between these the force along the road may move by itself: from the demand of the present steering angle
// and speed to zero. Past anything a vehicle can do where the demand is not known.
struct DemandedForce {
    float least_mps2{-60.0F};
    float most_mps2{60.0F};
    float force_mps2{0.0F};  // the demand itself, within +-60 m/s^2, if it is known
    bool is_known{false};
};

class SteeringDemand {
 public:
    SteeringDemand() = default;
    [[gnu::cold]] explicit SteeringDemand(const Parameters& parameters);

    // a_d = V^2 delta / (L + K_us V^2) plus what the bank adds to A, within what the tyres can give.
    DemandedForce evaluate(const Inputs& inputs, const Measurement& measured) const;

 private:
    float wheelbase_m_{};  // this and the next times the steering ratio
    float understeer_gradient_s2pm_{};
    float largest_mps2_{};
};

}  // namespace rsi
