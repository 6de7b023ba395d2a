#include "rsi/prediction/roll_predictor.hpp"

#include "rsi/indicator/extended_indicator.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

// Share of e that is applied: it is noisy, and undercorrecting costs less.
constexpr float trusted_share = 0.75F;
// Part of the response that is as certain as the present.
constexpr float sure_s = 0.1F;
constexpr std::uint32_t most_response_steps = 13U;

float suspension_moment_nm(const Vehicle& vehicle, const RollSpring& springs, float roll_rate_radps) {
    return springs.moment_nm + vehicle.suspension.damping_nmsprad * roll_rate_radps;
}

}  // namespace

RollPredictor::RollPredictor(const Parameters& parameters)
    : trend_horizon_s_(parameters.prediction_horizon_s),
      // Validated to 0 .. 0.5 s: at most 13 steps.
      response_steps_(static_cast<std::uint32_t>(
          parameters.response_horizon_s * (1.0F / LateralResponse::step_s) + 0.5F)),
      margin_per_step_(parameters.response_margin_per_s * LateralResponse::step_s),
      forecast_share_(parameters.forecast_share),
      forecast_limit_(parameters.forecast_limit) {
    const float trend_s = parameters.acceleration_trend_s;
    trend_after_horizon_s_ = trend_s * (1.0F - decaying_exponential(trend_horizon_s_ / trend_s));
}

// How far A follows its trend: not past what the steering asks for, nor past where it is; without a demand,
// past nothing.
float RollPredictor::force_change_mps2(const RollMotion& motion, const DemandedForce& demand) const {
    const float A = motion.road_parallel_force_mps2;
    const float change = motion.road_parallel_force_rate_mps3 * trend_after_horizon_s_;
    return (change > 0.0F) ? smaller(change, larger(A, demand.most_mps2) - A)
                           : larger(change, smaller(A, demand.least_mps2) - A);
}

// Trapezoidal rule, linearised with the stiffness of the instant: the suspension's less gravity's, at least
// zero. Its divisor is at least Ixx.
RollPredictor::State RollPredictor::after_step(const Vehicle& vehicle, const State& from, float dt,
                                               float force_mps2, const Moments& moments) {
    const float x = from.angle_rad;
    const float y = from.rate_radps;
    const float k = larger(from.springs.slope_nmprad - moments.gravity_nm * (1.0F + x * x), 0.0F);
    const float moment_nm = moments.arm_kgm * force_mps2 + moments.gravity_nm * short_tangent(x) -
                            suspension_moment_nm(vehicle, from.springs, y);
    const float change_radps = dt * (moment_nm - 0.5F * dt * k * y) /
                               (vehicle.loaded.body.roll_inertia_kgm2 +
                                0.5F * dt * vehicle.suspension.damping_nmsprad + 0.25F * dt * dt * k);
    const float x_then = clamp_magnitude(x + dt * (y + 0.5F * change_radps), largest_spring_angle_rad);
    return State{x_then, y + change_radps, vehicle.suspension.springs.at(x_then)};
}

float RollPredictor::load_after(const Vehicle& vehicle, const State& then, float force_change_mps2,
                                const Moments& moments) {
    return moments.load_nm + moments.force_arm_kgm * force_change_mps2 +
           suspension_moment_nm(vehicle, then.springs, then.rate_radps) - moments.suspension_nm;
}

void RollPredictor::follow_response(const Vehicle& vehicle, const RollMotion& motion, const State& present,
                                    const LateralResponse& response, const ForceTarget& target,
                                    const Moments& moments, Sides& largest) const {
    const float A = motion.road_parallel_force_mps2;
    ForceCourse force{A, motion.road_parallel_force_rate_mps3};
    State roll = present;
    float margin = -(sure_s / LateralResponse::step_s) * margin_per_step_;
    // Bounded whatever becomes of the number in memory.
    const std::uint32_t steps =
        (response_steps_ < most_response_steps) ? response_steps_ : most_response_steps;
    for (std::uint32_t step = 0U; step < steps; ++step) {
        const ForceCourse next = response.after_step(force, target);
        roll = after_step(vehicle, roll, LateralResponse::step_s, 0.5F * (force.force_mps2 + next.force_mps2),
                          moments);
        force = next;
        const float load_nm = load_after(vehicle, roll, force.force_mps2 - A, moments);
        const float ratio = load_transfer_ratio(vehicle.loaded, load_nm, motion.road_normal_force_mps2);
        margin += margin_per_step_;
        const float less = larger(margin, 0.0F);
        largest.right = larger(largest.right, ratio - less);
        largest.left = larger(largest.left, -ratio - less);
    }
}

// Bounded by the prediction, which is not negative, so that the forecast alone never warns; less far down
// than up, so that a wrong one takes little of a warning.
float RollPredictor::towards(float predicted, float forecast) const {
    const float most = forecast_limit_ * predicted;
    return predicted + clamp(forecast_share_ * (forecast - predicted), -0.25F * most, most);
}

Prediction RollPredictor::evaluate(const Vehicle& vehicle, const RollMotion& motion,
                                   const TransferredLoad& load, const DemandedForce& demand,
                                   const LateralResponse& response, const ForceTarget* target,
                                   float moment_arm_error, float forecast) const {
    const float moment_arm_kgm = vehicle.loaded.moment_arm_kgm;
    const float A = motion.road_parallel_force_mps2;
    const float N = motion.road_normal_force_mps2;
    const float correction_kgm = trusted_share * moment_arm_error * moment_arm_kgm;
    const float arm_kgm = moment_arm_kgm - correction_kgm;
    const Moments moments{arm_kgm, arm_kgm * N, load.suspension_moment_nm, load.moment_nm,
                          vehicle.loaded.force_arm_kgm + correction_kgm};

    const float change_mps2 = force_change_mps2(motion, demand);
    const State present{motion.roll_angle_rad, motion.roll_rate_radps,
                        vehicle.suspension.springs.at(motion.roll_angle_rad)};
    const State then = after_step(vehicle, present, trend_horizon_s_, A + 0.5F * change_mps2, moments);
    const float then_nm = load_after(vehicle, then, change_mps2, moments);
    const bool grows = absolute(then_nm) > absolute(load.moment_nm);
    const float worst_nm = grows ? then_nm : load.moment_nm;
    const float worst_force_mps2 = grows ? A + change_mps2 : A;

    const float ratio_then = load_transfer_ratio(vehicle.loaded, then_nm, N);
    Sides largest{larger(larger(load.ratio, ratio_then), 0.0F),
                  larger(larger(-load.ratio, -ratio_then), 0.0F)};
    if (target != nullptr) {
        follow_response(vehicle, motion, present, response, *target, moments, largest);
    }
    largest.right = towards(largest.right, forecast);
    largest.left = towards(largest.left, -forecast);
    // Wheels that are up come down before those of the other side can lift.
    largest.right = (load.ratio <= -1.0F) ? 0.0F : largest.right;
    largest.left = (load.ratio >= 1.0F) ? 0.0F : largest.left;
    const bool is_right = largest.right >= largest.left;
    return Prediction{is_right ? largest.right : -largest.left, is_right ? largest.left : largest.right,
                      extended_level_under_load(worst_force_mps2, N, worst_nm, vehicle.loaded)};
}

}  // namespace rsi
