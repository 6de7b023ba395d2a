#include "rsi/indicator/prediction.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr int step_count = 8;
constexpr float largest_predicted_angle_rad = 0.5F;
constexpr float largest_predicted_rate_radps = 10.0F;

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
    step_s_ = parameters.prediction_horizon_s / static_cast<float>(step_count);
    trend_s_ = parameters.acceleration_trend_s;
    trend_decay_ = decaying_exponential(step_s_ / trend_s_);
    moment_arm_kgm_ =
        parameters.sprung_mass_kg * (parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m);
    inertia_inverse_ = 1.0F / parameters.roll_inertia_kgm2;
    const float damping_nmsprad = parameters.roll_damping_nmsprad;
    // y(t) under M - c_f y: y + (M - c_f y) (1 - exp(-c_f t/Ixx)) / c_f.
    rate_gain_radpnms_ =
        (1.0F - decaying_exponential(damping_nmsprad * step_s_ * inertia_inverse_)) / damping_nmsprad;
}

Prediction RollPredictor::evaluate(const RollMotion& motion, const DemandedForce& demand,
                                   const LoadTransfer& load_transfer,
                                   const ExtendedIndicator& extended) const {
    const float N = motion.road_normal_force_mps2;
    const float normal_inverse = 1.0F / N;
    const ForceBounds bounds = bounds_of(motion.road_parallel_force_mps2, demand);
    const float full_trend_mps2 = motion.road_parallel_force_rate_mps3 * trend_s_;

    float x = clamp(motion.roll_angle_rad, -largest_predicted_angle_rad, largest_predicted_angle_rad);
    float y = motion.roll_rate_radps;
    float tan_x = short_tangent(x);
    float remaining = 1.0F;  // exp(-t/tau_j)
    float suspension_nm = load_transfer.suspension_moment_nm(x, y);
    const float present_moment_nm = load_transfer.moment_nm(motion.road_parallel_force_mps2, suspension_nm);
    const float present_level = extended.level(motion.road_parallel_force_mps2, normal_inverse, tan_x,
                                               motion.roll_acceleration_radps2);
    float worst_moment_nm = present_moment_nm;
    float worst_level = present_level;
    for (int step = 0; step < step_count; ++step) {
        remaining *= trend_decay_;
        const float a = clamp(motion.road_parallel_force_mps2 + full_trend_mps2 * (1.0F - remaining),
                              bounds.lowest, bounds.highest);
        const float moment_nm = moment_arm_kgm_ * (a + N * tan_x) - suspension_nm;
        y = clamp(y + rate_gain_radpnms_ * moment_nm, -largest_predicted_rate_radps,
                  largest_predicted_rate_radps);
        x = clamp(x + step_s_ * y, -largest_predicted_angle_rad, largest_predicted_angle_rad);
        tan_x = short_tangent(x);
        suspension_nm = load_transfer.suspension_moment_nm(x, y);
        const float transfer_nm = load_transfer.moment_nm(a, suspension_nm);
        worst_moment_nm = (absolute(transfer_nm) > absolute(worst_moment_nm)) ? transfer_nm : worst_moment_nm;
        worst_level =
            larger(extended.level(a, normal_inverse, tan_x, moment_nm * inertia_inverse_), worst_level);
    }
    Prediction prediction;
    prediction.present = RollRisk{load_transfer.ratio(present_moment_nm, normal_inverse), present_level};
    prediction.worst = RollRisk{load_transfer.ratio(worst_moment_nm, normal_inverse), worst_level};
    return prediction;
}

}  // namespace rsi
