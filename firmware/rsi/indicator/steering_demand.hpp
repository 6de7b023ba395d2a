// Steering demand: the lateral acceleration that the steering asks for.
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The steady force along the road for the present steering angle and speed.
struct DemandedForce {
    float parallel_mps2{0.0F};
    bool known{false};  // both speed and steering angle are available
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
