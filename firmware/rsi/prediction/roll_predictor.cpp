#include "rsi/prediction/roll_predictor.hpp"

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

// Of e: it is noisy, and a little too little of it costs less than too much.
constexpr float trusted_share = 0.75F;

}  // namespace

void RollPredictor::init(const Parameters& parameters) {
    step_s_ = parameters.prediction_horizon_s;
    const float trend_s = parameters.acceleration_trend_s;
    trend_after_step_s_ = trend_s * (1.0F - decaying_exponential(step_s_ / trend_s));
    moment_arm_kgm_ = parameters.sprung_mass_kg * roll_arm_m(parameters);
    roll_inertia_kgm2_ = parameters.roll_inertia_kgm2;
    roll_damping_nmsprad_ = parameters.roll_damping_nmsprad;
}

// How far A follows its trend: not past what the steering asks for, nor past where it is; without a demand,
// past nothing.
float RollPredictor::force_change_mps2(const RollMotion& motion, const DemandedForce& demand) const {
    const float A = motion.road_parallel_force_mps2;
    const float change = motion.road_parallel_force_rate_mps3 * trend_after_step_s_;
    return (change > 0.0F) ? smaller(change, larger(A, demand.most_mps2) - A)
                           : larger(change, smaller(A, demand.least_mps2) - A);
}

// Trapezoidal rule, linearised with the stiffness of the instant: the suspension's less gravity's, at least
// zero. Its divisor is at least Ixx.
RollPredictor::State RollPredictor::after_step(const State& from, float force_mps2, const Arm& arm,
                                               const LoadTransfer& load_transfer) const {
    const float dt = step_s_;
    const float x = from.angle_rad;
    const float y = from.rate_radps;
    const float k =
        larger(load_transfer.suspension_stiffness_nmprad(x) - arm.gravity_nm * (1.0F + x * x), 0.0F);
    const float moment_nm = arm.force_kgm * force_mps2 + arm.gravity_nm * short_tangent(x) -
                            load_transfer.suspension_moment_nm(x, y);
    const float change_radps = dt * (moment_nm - 0.5F * dt * k * y) /
                               (roll_inertia_kgm2_ + 0.5F * dt * roll_damping_nmsprad_ + 0.25F * dt * dt * k);
    const float x_then = clamp_magnitude(x + dt * (y + 0.5F * change_radps), largest_spring_angle_rad);
    return State{x_then, y + change_radps};
}

Prediction RollPredictor::evaluate(const RollMotion& motion, const TransferredLoad& load,
                                   const DemandedForce& demand, float moment_arm_error,
                                   const LoadTransfer& load_transfer,
                                   const ExtendedIndicator& extended) const {
    const float A = motion.road_parallel_force_mps2;
    const float N = motion.road_normal_force_mps2;
    const float change_mps2 = force_change_mps2(motion, demand);

    const float correction_kgm = trusted_share * moment_arm_error * moment_arm_kgm_;
    const float arm_kgm = moment_arm_kgm_ - correction_kgm;
    const State then = after_step(State{motion.roll_angle_rad, motion.roll_rate_radps},
                                  A + 0.5F * change_mps2, Arm{arm_kgm, arm_kgm * N}, load_transfer);
    const float suspension_change_nm =
        load_transfer.suspension_moment_nm(then.angle_rad, then.rate_radps) - load.suspension_moment_nm;
    const float then_nm = load.moment_nm + (load_transfer.force_arm_kgm() + correction_kgm) * change_mps2 +
                          suspension_change_nm;

    const bool grows = absolute(then_nm) > absolute(load.moment_nm);
    const float worst_nm = grows ? then_nm : load.moment_nm;
    const float worst_force_mps2 = grows ? A + change_mps2 : A;
    return Prediction{load_transfer.ratio(worst_nm, N),
                      extended.level_under_load(worst_force_mps2, N, worst_nm)};
}

}  // namespace rsi
