// Steering demand: the lateral acceleration that the steering asks for.
#pragma once

#include <cstdint>

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

// a_d = V^2 delta / (L + K_us V^2) plus what the bank adds to A, within what the tyres can give. In a spin the
// vehicle goes where it slides, so nothing is known.
class SteeringDemand {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);
    void reset() { spin_samples_ = 0U; }
    DemandedForce update(const Inputs& inputs, const Measurement& measured);

 private:
    bool spins(float yaw_acceleration_mps2, float road_parallel_force_mps2);

    float wheelbase_m_{1.0F};  // this and the next times the steering ratio
    float understeer_gradient_s2pm_{0.0F};
    float largest_mps2_{1.0F};
    std::uint32_t spin_samples_{0U};  // so many more until the spin is over
};

}  // namespace rsi
