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

// a_d = V^2 delta / (L + K_us V^2) plus what the bank adds to A, within what the tyres can give.
class SteeringDemand {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);
    DemandedForce evaluate(const Inputs& inputs, const Measurement& measured) const;

 private:
    float wheelbase_m_{1.0F};  // this and the next times the steering ratio
    float understeer_gradient_s2pm_{0.0F};
    float largest_mps2_{1.0F};
};

}  // namespace rsi
