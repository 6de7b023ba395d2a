#include "rsi/indicator/prediction.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr float largest_ratio = 20.0F;
// Of e: it is noisy, and a little too little of it costs less than too much.
constexpr float trusted_share = 0.75F;
// How much A may change in the direction of its trend: not past what the steering asks for, nor past where it
// is; without a demand, past nothing. Signed like the trend.
float room_for_change(float force_mps2, bool grows, const DemandedForce& demand) {
    return (grows ? larger(force_mps2, demand.most_mps2) : smaller(force_mps2, demand.least_mps2)) -
           force_mps2;
}

// Both of one sign.
float no_further_than(float room, float change) {
    return (absolute(change) > absolute(room)) ? room : change;
}

}  // namespace

void RollPredictor::init(const Parameters& parameters) {
    step_s_ = parameters.prediction_horizon_s;
    half_step_s_ = 0.5F * step_s_;
    const float trend_s = parameters.acceleration_trend_s;
    trend_after_step_s_ = trend_s * (1.0F - decaying_exponential(step_s_ / trend_s));
    moment_arm_kgm_ =
        parameters.sprung_mass_kg * (parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m);
    inertia_and_damping_kgm2_ = parameters.roll_inertia_kgm2 + half_step_s_ * parameters.roll_damping_nmsprad;
}

// Linearised with the stiffness of the instant: the suspension's less gravity's.
RollPredictor::Motion RollPredictor::after_step(const Motion& from, float force_mps2, float arm_kgm,
                                                float gravity_nm, const LoadTransfer& load_transfer) const {
    const float x = from.angle_rad;
    const float y = from.rate_radps;
    const float half_step_stiffness_nms =
        half_step_s_ *
        larger(load_transfer.suspension_stiffness_nmprad(x) - gravity_nm * (1.0F + x * x), 0.0F);
    const float moment_nm = arm_kgm * force_mps2 + gravity_nm * short_tangent(x) - from.suspension_nm;
    const float change_radps = step_s_ * (moment_nm - half_step_stiffness_nms * y) /
                               (inertia_and_damping_kgm2_ + half_step_s_ * half_step_stiffness_nms);
    Motion to;
    to.rate_radps = y + change_radps;
    to.angle_rad = clamp_magnitude(x + half_step_s_ * (y + to.rate_radps), largest_spring_angle_rad);
    to.suspension_nm = load_transfer.suspension_moment_nm(to.angle_rad, to.rate_radps);
    return to;
}

Prediction RollPredictor::evaluate(const RollMotion& motion, const DemandedForce& demand,
                                   const LoadTransfer& load_transfer, const ExtendedIndicator& extended,
                                   float suspension_moment_nm, float moment_arm_error) const {
    const float A = motion.road_parallel_force_mps2;
    const float N = motion.road_normal_force_mps2;
    const float trend = motion.road_parallel_force_rate_mps3;
    const float room = room_for_change(A, trend > 0.0F, demand);
    const float change = no_further_than(room, trend * trend_after_step_s_);

    const float correction_kgm = trusted_share * moment_arm_error * moment_arm_kgm_;
    const float arm_kgm = moment_arm_kgm_ - correction_kgm;
    const float gravity_nm = arm_kgm * N;
    const Motion now{motion.roll_angle_rad, motion.roll_rate_radps, suspension_moment_nm};
    const Motion then = after_step(now, A + 0.5F * change, arm_kgm, gravity_nm, load_transfer);

    const float force_arm_kgm = load_transfer.force_arm_kgm() + correction_kgm;
    const float present_nm = load_transfer.present_moment_nm(motion, now.suspension_nm);
    const float then_nm = present_nm + force_arm_kgm * change + (then.suspension_nm - now.suspension_nm);
    const bool grows = absolute(then_nm) > absolute(present_nm);
    const float worst_nm = grows ? then_nm : present_nm;
    const float worst_force_mps2 = grows ? A + change : A;

    const float N_inverse = 1.0F / N;
    Prediction prediction;
    prediction.present.load_transfer_ratio = load_transfer.ratio(present_nm, N_inverse);
    prediction.present.rsi_extended =
        extended.level(A, N, short_tangent(motion.roll_angle_rad), motion.roll_acceleration_radps2);
    prediction.worst.load_transfer_ratio = load_transfer.ratio(worst_nm, N_inverse);
    prediction.worst.rsi_extended =
        larger(prediction.present.rsi_extended, extended.level_under_load(worst_force_mps2, N, worst_nm));
    // The present one is no further from zero.
    if (absolute(prediction.worst.load_transfer_ratio) > largest_ratio) {
        prediction.worst.load_transfer_ratio =
            clamp_magnitude(prediction.worst.load_transfer_ratio, largest_ratio);
        prediction.present.load_transfer_ratio =
            clamp_magnitude(prediction.present.load_transfer_ratio, largest_ratio);
    }
    return prediction;
}

}  // namespace rsi
