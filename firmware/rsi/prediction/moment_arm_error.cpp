#include "rsi/prediction/moment_arm_error.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/square.hpp"

namespace rsi {
namespace {

// About what K within 10 % and a CG height within 5 % make, as a standard deviation.
constexpr float prior_deviation = 0.06F;
constexpr float largest_error = 0.35F;
// e returns to zero in 2 s, so that a load that has left is forgotten.
constexpr float error_reversion = 0.6F * sample_time_s;
// Noise of one sample, as a share of m_s g H, and what the calibration's other terms may be wrong by.
constexpr float sample_noise_share = 0.06F;
constexpr float stiffness_share = 0.07F;
constexpr float damping_share = 0.25F;
constexpr float inertia_share = 0.3F;
// Neighbouring samples are alike, because all signals are lagged.
constexpr float noise_correlation = 3.0F;

}  // namespace

void MomentArmError::tune(const Parameters& parameters) {
    assume_body(calibrated_body(parameters));
    stiffness_noise_ = noise_correlation * square(stiffness_share * parameters.roll_stiffness_nmprad);
    damping_noise_ = noise_correlation * square(damping_share * parameters.roll_damping_nmsprad);
    excitation_nm_ = moment_arm_kgm_ * parameters.excitation_threshold_mps2;
    noise_nm2_ = noise_correlation * square(sample_noise_share * gravity_mps2 * moment_arm_kgm_);
}

void MomentArmError::reset() {
    error_ = 0.0F;
    variance_ = square(prior_deviation);
}

float MomentArmError::update(const RollMotion& motion, const TransferredLoad& load, bool measured_angle) {
    error_ -= error_reversion * error_;
    variance_ += 2.0F * error_reversion * (square(prior_deviation) - variance_);
    const float arm_nm =
        moment_arm_kgm_ * (motion.road_parallel_force_mps2 +
                           motion.road_normal_force_mps2 * short_tangent(motion.roll_angle_rad));
    // With the inner wheels up the roll equation does not hold.
    const bool learns =
        measured_angle && (absolute(arm_nm) > excitation_nm_) && (absolute(load.ratio) < 1.0F);
    if (learns) {
        const float inertia_nm = inertia_kgm2_ * motion.roll_acceleration_radps2;
        const float noise = noise_nm2_ + stiffness_noise_ * square(motion.roll_angle_rad) +
                            damping_noise_ * square(motion.roll_rate_radps) +
                            noise_correlation * square(inertia_share) * square(inertia_nm);
        // Divided by at least the noise, which is positive.
        const float covariance = arm_nm * variance_;
        const float weight = 1.0F / (arm_nm * covariance + noise);
        error_ += weight * covariance * (arm_nm - load.suspension_moment_nm - inertia_nm - arm_nm * error_);
        variance_ *= weight * noise;
    }
    error_ = clamp_magnitude(error_, largest_error);
    return error_;
}

}  // namespace rsi
