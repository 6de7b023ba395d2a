#include "rsi/adaptation/load_regression.hpp"

#include "rsi/adaptation/load_bounds.hpp"
#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/square.hpp"
#include "rsi/numeric/square_root.hpp"

namespace rsi {
namespace {

// Smaller forces show little but offsets, larger ones bend the springs and lift wheels.
constexpr float ordinary_from_mps2 = 0.8F;
constexpr float ordinary_to_mps2 = 4.0F;
constexpr float ordinary_load_transfer = 0.7F;

// Before anything is learnt, standard deviations.
constexpr float excess_prior = largest_load_excess_deviation;
constexpr float load_offset_prior_mps2 = 0.5F;
constexpr float largest_load_offset_mps2 = 2.0F;
// Lower bounds of the deviations: the calibrated springs are not more accurate, and the filter must keep
// adapting.
constexpr float least_excess_deviation = 0.01F;
constexpr float least_load_offset_deviation_mps2 = 0.01F;
// Random walk of x and d: fuel, passengers at a short stop, a sensor that warms up.
constexpr float excess_drift_per_root_s = 0.002F;
constexpr float load_offset_drift_mps2_per_root_s = 0.005F;
// After a possible change of load: share of the estimate that is kept, and deviation that is added.
constexpr float kept_share = 0.5F;
constexpr float doubted_deviation = 0.15F;

// Noise model of one sample's equation: sensors, road and movement of the roll centre, plus the relative
// errors of the calibrated damping and inertia. The noise is correlated over about 2 s, so the samples of
// that time count as one.
constexpr float equation_noise_mps2 = 0.03F * gravity_mps2;
constexpr float unknown_damping = 0.25F;
constexpr float unknown_inertia = 0.3F;
constexpr float samples_alike = 2.0F / sample_time_s;
// Outliers such as kerbs and potholes: beyond three standard deviations the weight falls with the innovation
// squared.
constexpr float usual_variances = 9.0F;

bool is_ordinary_turn(const RollMotion& motion, const TransferredLoad& load) {
    return is_within(absolute(motion.road_parallel_force_mps2), ordinary_from_mps2, ordinary_to_mps2) &&
           is_within_magnitude(load.ratio, ordinary_load_transfer);
}

}  // namespace

// The validation of the parameters makes H 0.01 m or more.
LoadRegression::Constants::Constants(const Parameters& parameters)
    : moment_to_force(1.0F / (parameters.sprung_mass_kg * roll_arm_m(parameters))),
      inertia_to_force_m(parameters.roll_inertia_kgm2 * moment_to_force),
      damping_to_force_mps(parameters.roll_damping_nmsprad * moment_to_force) {}

void LoadRegression::reset() {
    theta_.setZero();
    assumed_ = 0.0F;
    covariance_ << square(excess_prior), 0.0F, 0.0F, square(load_offset_prior_mps2);
}

bool LoadRegression::update(const Constants& constants, const RollMotion& motion,
                            const TransferredLoad& load) {
    pass_time();
    if (!is_ordinary_turn(motion, load)) {
        return true;
    }
    const float f = motion.road_parallel_force_mps2 +
                    motion.road_normal_force_mps2 * short_tangent(motion.roll_angle_rad);
    const float inertia_mps2 = constants.inertia_to_force_m * motion.roll_acceleration_radps2;
    const float damping_mps2 = constants.damping_to_force_mps * motion.roll_rate_radps;
    const float output_mps2 = constants.moment_to_force * load.suspension_moment_nm + inertia_mps2 - f;
    learn(Vector2{f, 1.0F}, output_mps2,
          square(equation_noise_mps2) + square(unknown_damping * damping_mps2) +
              square(unknown_inertia * inertia_mps2));
    return keep_in_bounds();
}

void LoadRegression::pass_time() {
    constexpr float drift = square(excess_drift_per_root_s) * sample_time_s;
    constexpr float offset_drift = square(load_offset_drift_mps2_per_root_s) * sample_time_s;
    float& variance = covariance_(excess_at, excess_at);
    float& offset_variance = covariance_(offset_at, offset_at);
    variance = smaller(variance + drift, square(excess_prior));
    offset_variance = smaller(offset_variance + offset_drift, square(load_offset_prior_mps2));
}

// Equations (9) and (10), with the measurement variance in place of 1.
void LoadRegression::learn(const Vector2& psi, float output_mps2, float noise_mps4) {
    const Vector2 g = covariance_ * psi;
    const float spread = absolute(psi.dot(g));  // negative only by rounding
    const float innovation = output_mps2 - psi.dot(theta_);
    const float size = square(innovation);
    const float usual = usual_variances * (spread + noise_mps4);
    const float weight = (size > usual) ? usual / size : 1.0F;
    // The divisor is positive, because the noise is.
    const float gain = weight / (spread + samples_alike * noise_mps4);
    theta_ += g * (gain * innovation);
    // As much of what was assumed is left as of the variance.
    const float variance = covariance_(excess_at, excess_at);
    // The update is symmetric to the last bit, so P stays symmetric.
    covariance_ -= (g * g.transpose()) * gain;
    assumed_ *= covariance_(excess_at, excess_at) / variance;
}

// A value that is not finite in any signal shows in theta or P. Raising a variance keeps P positive definite.
bool LoadRegression::keep_in_bounds() {
    const bool sound = is_finite(theta_.sum() + covariance_.sum());
    if (!sound) {
        reset();
    }
    theta_(excess_at) = clamp(theta_(excess_at), least_load_excess, largest_load_excess);
    theta_(offset_at) = clamp_magnitude(theta_(offset_at), largest_load_offset_mps2);
    float& variance = covariance_(excess_at, excess_at);
    float& offset_variance = covariance_(offset_at, offset_at);
    variance = larger(variance, square(least_excess_deviation));
    offset_variance = larger(offset_variance, square(least_load_offset_deviation_mps2));
    return sound;
}

void LoadRegression::doubt(float expected) {
    theta_(excess_at) =
        clamp(expected + kept_share * (theta_(excess_at) - expected), least_load_excess, largest_load_excess);
    assumed_ = expected + kept_share * (assumed_ - expected);
    const float variance = covariance_(excess_at, excess_at) + square(doubted_deviation);
    covariance_ << smaller(variance, square(excess_prior)), 0.0F, 0.0F, square(load_offset_prior_mps2);
}

void LoadRegression::expect_change(float change) {
    const float unknown_share = covariance_(excess_at, excess_at) * (1.0F / square(excess_prior));
    assume(unknown_share * change);
}

void LoadRegression::add_load(float change) {
    assume(change);
    const float variance = covariance_(excess_at, excess_at) + square(0.5F * change);
    covariance_ << smaller(variance, square(excess_prior)), 0.0F, 0.0F, square(load_offset_prior_mps2);
}

void LoadRegression::assume(float change) {
    const float before = theta_(excess_at);
    theta_(excess_at) = clamp(before + change, least_load_excess, largest_load_excess);
    assumed_ += theta_(excess_at) - before;
}

float LoadRegression::excess_deviation() const {
    return square_root(covariance_(excess_at, excess_at));
}

LearntLoad LoadRegression::learnt() const {
    return LearntLoad{theta_(excess_at), excess_deviation(), theta_(offset_at)};
}

bool LoadRegression::restore(const LearntLoad& learnt) {
    if (!is_within(learnt.excess, least_load_excess, largest_load_excess) ||
        !is_within(learnt.excess_deviation, least_excess_deviation, excess_prior) ||
        !is_within_magnitude(learnt.offset_mps2, largest_load_offset_mps2)) {
        return false;
    }
    theta_ << learnt.excess, learnt.offset_mps2;
    assumed_ = 0.0F;
    covariance_ << square(learnt.excess_deviation), 0.0F, 0.0F, square(load_offset_prior_mps2);
    return true;
}

}  // namespace rsi
