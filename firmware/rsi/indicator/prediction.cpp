#include "rsi/indicator/prediction.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr int step_count = 4;
constexpr float largest_predicted_angle_rad = 0.5F;
// Of e: it is noisy, and a little too little of it costs less than too much.
constexpr float trusted_share = 0.75F;

struct ForceBounds {
    float lowest;
    float highest;
};

// What A may grow to: not past what the steering asks for, nor past where it is; without a demand, past
// nothing.
ForceBounds bounds_of(float force_mps2, const DemandedForce& demand) {
    if (!demand.known) {
        return ForceBounds{-60.0F, 60.0F};
    }
    const float d = demand.parallel_mps2;
    return ForceBounds{smaller(smaller(force_mps2, d), 0.0F), larger(larger(force_mps2, d), 0.0F)};
}

}  // namespace

void RollPredictor::init(const Parameters& parameters) {
    const float step_s = parameters.prediction_horizon_s / static_cast<float>(step_count);
    half_step_s_ = 0.5F * step_s;
    trend_s_ = parameters.acceleration_trend_s;
    trend_decay_ = decaying_exponential(step_s / trend_s_);
    moment_arm_kgm_ =
        parameters.sprung_mass_kg * (parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m);
    // Positive: K_f >= 1.2 m_s g H is validated.
    half_step_stiffness_nms_ =
        (parameters.roll_stiffness_nmprad - moment_arm_kgm_ * gravity_mps2) * half_step_s_;
    rate_gain_radpnms_ =
        step_s / (parameters.roll_inertia_kgm2 +
                  half_step_s_ * (parameters.roll_damping_nmsprad + half_step_stiffness_nms_));
}

Prediction RollPredictor::evaluate(const RollMotion& motion, const DemandedForce& demand,
                                   const LoadTransfer& load_transfer, const ExtendedIndicator& extended,
                                   float moment_arm_error) const {
    const float A = motion.road_parallel_force_mps2;
    const float N = motion.road_normal_force_mps2;
    const ForceBounds bounds = bounds_of(A, demand);
    const float settled_force_mps2 = A + motion.road_parallel_force_rate_mps3 * trend_s_;
    float outstanding_mps2 = motion.road_parallel_force_rate_mps3 * trend_s_;

    float x = clamp_magnitude(motion.roll_angle_rad, largest_predicted_angle_rad);
    float y = motion.roll_rate_radps;
    float a = A;
    float suspension_nm = load_transfer.suspension_moment_nm(x, y);
    const float correction_kgm = trusted_share * moment_arm_error * moment_arm_kgm_;
    const float force_arm_kgm = load_transfer.force_arm_kgm() + correction_kgm;
    const float arm_kgm = moment_arm_kgm_ - correction_kgm;
    const float present_nm = load_transfer.present_moment_nm(motion, suspension_nm);
    const float offset_nm = present_nm - force_arm_kgm * a - suspension_nm;
    float lowest_nm = present_nm;
    float highest_nm = present_nm;
    for (int step = 0; step < step_count; ++step) {
        outstanding_mps2 *= trend_decay_;
        const float next_a = clamp(settled_force_mps2 - outstanding_mps2, bounds.lowest, bounds.highest);
        const float mean_a = 0.5F * (a + next_a);
        const float moment_nm = arm_kgm * (mean_a + N * short_tangent(x)) - suspension_nm;
        const float next_y = y + rate_gain_radpnms_ * (moment_nm - half_step_stiffness_nms_ * y);
        x = clamp_magnitude(x + half_step_s_ * (y + next_y), largest_predicted_angle_rad);
        y = next_y;
        a = next_a;
        suspension_nm = load_transfer.suspension_moment_nm(x, y);
        const float transfer_nm = offset_nm + force_arm_kgm * a + suspension_nm;
        lowest_nm = smaller(lowest_nm, transfer_nm);
        highest_nm = larger(highest_nm, transfer_nm);
    }

    const float N_inverse = 1.0F / N;
    const float worst_nm = (-lowest_nm > highest_nm) ? lowest_nm : highest_nm;
    Prediction prediction;
    prediction.present.load_transfer_ratio = load_transfer.ratio(present_nm, N_inverse);
    prediction.present.rsi_extended =
        extended.level(A, N, short_tangent(motion.roll_angle_rad), motion.roll_acceleration_radps2);
    prediction.worst.load_transfer_ratio = load_transfer.ratio(worst_nm, N_inverse);
    const float worst_a = (worst_nm < 0.0F) ? smaller(A, a) : larger(A, a);
    prediction.worst.rsi_extended =
        larger(prediction.present.rsi_extended, extended.level_under_load(worst_a, N, worst_nm));
    return prediction;
}

}  // namespace rsi
