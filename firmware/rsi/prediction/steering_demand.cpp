#include "rsi/prediction/steering_demand.hpp"

#include "rsi/measurement/plausible_motion.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

constexpr float largest_steering_wheel_angle_rad = 30.0F;
constexpr float largest_demand_mps2 = 60.0F;

}  // namespace

SteeringDemand::SteeringDemand(const Parameters& parameters)
    : wheelbase_m_(parameters.steering_ratio * parameters.wheelbase_m),
      understeer_gradient_s2pm_(parameters.steering_ratio * parameters.understeer_gradient_s2pm),
      largest_mps2_(parameters.largest_lateral_acceleration_mps2) {}

DemandedForce SteeringDemand::evaluate(const Inputs& inputs, const Measurement& measured) const {
    if (!is_within_magnitude(inputs.speed_mps, largest_plausible_speed_mps) ||
        !is_within_magnitude(inputs.steering_wheel_angle_rad, largest_steering_wheel_angle_rad)) {
        return DemandedForce{};
    }
    const float speed_squared = inputs.speed_mps * inputs.speed_mps;
    // An oversteering vehicle near or past its critical speed has an unbounded demand; the tyres bound it.
    const float divisor_m =
        larger(wheelbase_m_ + understeer_gradient_s2pm_ * speed_squared, 0.1F * wheelbase_m_);
    const float demanded = speed_squared * inputs.steering_wheel_angle_rad / divisor_m;
    // A - a_y is the bank's share, zero where the bank is not known.
    const float bank_share = measured.road_parallel_force_mps2 - measured.lateral_acceleration_mps2;
    const float bounded = clamp_magnitude(demanded + bank_share, largest_mps2_);
    return DemandedForce{smaller(bounded, 0.0F), larger(bounded, 0.0F),
                         clamp_magnitude(demanded + bank_share, largest_demand_mps2), true};
}

}  // namespace rsi
