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

MomentArmError::Constants::Constants(const Parameters& parameters)
    : stiffness_noise(noise_correlation * square(stiffness_share * parameters.roll_stiffness_nmprad)),
      damping_noise(noise_correlation * square(damping_share * parameters.roll_damping_nmsprad)) {
    const float moment_arm_kgm = calibrated_body(parameters).moment_arm_kgm();
    excitation_nm = moment_arm_kgm * parameters.excitation_threshold_mps2;
    noise_nm2 = noise_correlation * square(sample_noise_share * gravity_mps2 * moment_arm_kgm);
}

void MomentArmError::reset() {
    error_ = 0.0F;
    variance_ = square(prior_deviation);
}

float MomentArmError::update(const Constants& constants, const LoadedBody& loaded, const RollMotion& motion,
                             const TransferredLoad& load, bool measured_angle) {
    error_ -= error_reversion * error_;
    variance_ += 2.0F * error_reversion * (square(prior_deviation) - variance_);
    const float arm_nm =
        loaded.moment_arm_kgm * (motion.road_parallel_force_mps2 +
                                 motion.road_normal_force_mps2 * short_tangent(motion.roll_angle_rad));
    // With the inner wheels up the roll equation does not hold.
    const bool learns =
        measured_angle && (absolute(arm_nm) > constants.excitation_nm) && (absolute(load.ratio) < 1.0F);
    if (learns) {
        const float inertia_nm = loaded.body.roll_inertia_kgm2 * motion.roll_acceleration_radps2;
        const float noise = constants.noise_nm2 + constants.stiffness_noise * square(motion.roll_angle_rad) +
                            constants.damping_noise * square(motion.roll_rate_radps) +
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
