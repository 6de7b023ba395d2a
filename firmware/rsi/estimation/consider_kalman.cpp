#include "rsi/estimation/consider_kalman.hpp"

#include "rsi/numeric/bounded_functions.hpp"
#include "rsi/numeric/square.hpp"
#include "rsi/numeric/square_root.hpp"

namespace rsi {
namespace {

// What the calibration and the sensors are taken to be wrong by, one standard deviation each.
constexpr float stiffness_error = 0.07F;
constexpr float damping_error = 0.25F;
constexpr float inertia_error = 0.3F;
constexpr float offset_prior_mps2 = 0.03F * gravity_mps2;
constexpr float offset_drift_mps2_per_root_s = 0.0005F * gravity_mps2;
// The noise of neighbouring samples is alike, because F makes it so; both numbers are larger for that.
constexpr float noise_nm = 400.0F;
constexpr float correlation = 3.0F;
// The variance holds what neighbouring samples share, so one sample's innovation is far smaller as a rule.
// Beyond half a standard deviation it loses weight with the square of its size: a kerb, a pothole.
constexpr float outlier_variances = 0.25F;
// d is learnt below this share of the excitation threshold.
constexpr float straight_share = 0.5F;
// d is known once its deviation is below this share of its prior.
constexpr float learnt_share = 0.5F;
constexpr float smallest_deviation_m = 1.0e-3F;
// dh depends on how the suspension stands: it moves while the body rolls, by its prior deviation in about
// this angle, and hardly in a steady turn.
constexpr float memory_angle_rad = 0.05F;
constexpr float steady_share = 0.1F;  // of the mean reversion that remains in a steady turn
// Harder braking and faster gathering of speed pitch the body and move the suspension away from the stiffness
// curve.
constexpr float largest_speed_change_mps2 = 2.5F;
constexpr float speed_lag_s = 0.1F;
// Rolling faster than this is no driving straight.
constexpr float straight_roll_rate_radps = 0.01F;

}  // namespace

void ConsiderKalman::init(const Parameters& parameters) {
    equation_.init(parameters);
    prior_variance_m2_ = square(parameters.roll_centre_prior_deviation_m);
    reversion_ = 1.0F - decaying_exponential(sample_time_s / parameters.roll_centre_reversion_s);
    limit_m_ = parameters.roll_centre_limit_m;
    excitation_threshold_n_ = parameters.sprung_mass_kg * parameters.excitation_threshold_mps2;
    freeze_level_ = parameters.freeze_level;
    steady_reversion_ = steady_share * reversion_;
    noise_nm2_ = correlation * square(noise_nm);
    damping_noise_nm2s2_ = correlation * square(damping_error * parameters.roll_damping_nmsprad);
    const float nm_per_mps2 =
        parameters.sprung_mass_kg * (parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m);
    offset_prior_nm2_ = square(offset_prior_mps2 * nm_per_mps2);
    offset_drift_nm2_ = square(offset_drift_mps2_per_root_s * nm_per_mps2) * sample_time_s;
    reset();
}

void ConsiderKalman::reset() {
    restart();
    movement_m_ = 0.0F;
    variance_m2_ = prior_variance_m2_;
    stiffness_covariance_m_ = 0.0F;
    offset_covariance_nm2_ = 0.0F;
    offset_nm_ = 0.0F;
    offset_variance_nm2_ = offset_prior_nm2_;
}

RollCentreEstimate ConsiderKalman::update(const Measurement& measured, float extended_rsi, float speed_mps) {
    const RollEquation equation = equation_.update(measured);
    const bool speed_changes = changes_speed(speed_mps);
    // An angle that the observer made with the nominal model says nothing about dh.
    const bool held =
        (extended_rsi > freeze_level_) || speed_changes || (measured.roll_source == RSI_ROLL_OBSERVER);
    const float force_n = absolute(equation.lateral_force_n);
    const bool excited = force_n > excitation_threshold_n_;
    // A turn cannot tell an unknown offset from dh.
    const bool offset_known = offset_variance_nm2_ < square(learnt_share) * offset_prior_nm2_;
    const bool learns = equation.settled && excited && offset_known && !held;
    pass_time(equation, excited, held);
    if (learns) {
        learn_movement(equation);
    } else if (equation.settled && (force_n < straight_share * excitation_threshold_n_) &&
               (absolute(equation.roll_rate_radps) < straight_roll_rate_radps)) {
        learn_offset(equation);
    } else {
        // Between the two, it cannot be told which of them it is.
    }
    RollCentreEstimate estimate;
    if (!all_finite(equation)) {
        reset();
        estimate.deviation_m = square_root(variance_m2_);
        estimate.frozen = true;
        return estimate;
    }
    estimate.vertical_movement_m = movement_m_;
    estimate.stiffness_deviation_nmprad = equation.stiffness_deviation_nmprad;
    estimate.disturbance_nm = equation.residual_nm - equation.lateral_force_n * movement_m_;
    estimate.inertia_moment_nm = -equation.inertia_moment_nm;
    estimate.deviation_m = square_root(variance_m2_);
    estimate.frozen = !learns;
    return estimate;
}

void ConsiderKalman::pass_time(const RollEquation& equation, bool excited, bool held) {
    const float rolled = absolute(equation.roll_rate_radps) * (sample_time_s / memory_angle_rad);
    const float forgotten = (excited ? steady_reversion_ : reversion_) + rolled;
    const float retention = 1.0F - smaller(forgotten, 0.5F);
    variance_m2_ = prior_variance_m2_ + square(retention) * (variance_m2_ - prior_variance_m2_);
    offset_variance_nm2_ = smaller(offset_variance_nm2_ + offset_drift_nm2_, offset_prior_nm2_);
    if (!held) {
        movement_m_ *= retention;
        stiffness_covariance_m_ *= retention;
        offset_covariance_nm2_ *= retention;
    }
}

// A speed that is not available does not hold.
bool ConsiderKalman::changes_speed(float speed_mps) {
    if (!is_within(speed_mps, 0.0F, 150.0F)) {
        speed_known_ = false;
        return false;
    }
    if (!speed_known_) {
        lagged_speed_mps_ = speed_mps;
        speed_known_ = true;
    }
    const float behind_mps = lagged_speed_mps_ - speed_mps;
    lagged_speed_mps_ -= behind_mps * (sample_time_s / speed_lag_s);
    return absolute(behind_mps) > largest_speed_change_mps2 * speed_lag_s;
}

ConsiderKalman::Innovation ConsiderKalman::innovation(const RollEquation& equation) const {
    const float G = equation.lateral_force_n;
    const float M = equation.stiffness_moment_nm;
    const float noise = noise_nm2_ + damping_noise_nm2s2_ * square(equation.roll_rate_radps) +
                        correlation * square(inertia_error) * square(equation.inertia_moment_nm);
    Innovation innovation;
    innovation.value_nm = equation.residual_nm - G * movement_m_ - offset_nm_;
    innovation.with_movement = G * variance_m2_ + M * stiffness_covariance_m_ + offset_covariance_nm2_;
    innovation.with_stiffness = G * stiffness_covariance_m_ + M * square(stiffness_error);
    innovation.with_offset = G * offset_covariance_nm2_ + offset_variance_nm2_;
    innovation.variance_nm2 =
        G * innovation.with_movement + M * innovation.with_stiffness + innovation.with_offset + noise;
    // Positive semidefinite in exact numbers; rounding must not undercut the noise.
    innovation.variance_nm2 = larger(innovation.variance_nm2, noise_nm2_);
    const float size = square(innovation.value_nm);
    const float usual = outlier_variances * innovation.variance_nm2;
    innovation.weight = (size > usual) ? usual / size : 1.0F;
    return innovation;
}

void ConsiderKalman::learn_movement(const RollEquation& equation) {
    const Innovation e = innovation(equation);
    const float gain = e.weight * e.with_movement / e.variance_nm2;
    movement_m_ = clamp_magnitude(movement_m_ + gain * e.value_nm, limit_m_);
    variance_m2_ -= (2.0F - e.weight) * gain * e.with_movement;
    variance_m2_ = clamp(variance_m2_, square(smallest_deviation_m), prior_variance_m2_);
    stiffness_covariance_m_ -= gain * e.with_stiffness;
    offset_covariance_nm2_ -= gain * e.with_offset;
}

void ConsiderKalman::learn_offset(const RollEquation& equation) {
    const Innovation e = innovation(equation);
    const float gain = e.weight * e.with_offset / e.variance_nm2;
    offset_nm_ += gain * e.value_nm;
    offset_variance_nm2_ -= (2.0F - e.weight) * gain * e.with_offset;
    offset_variance_nm2_ = larger(offset_variance_nm2_, offset_drift_nm2_);
    offset_covariance_nm2_ -= gain * e.with_movement;
}

// Every signal of the equation is in its residual. A sum is not finite when a summand is not.
bool ConsiderKalman::all_finite(const RollEquation& equation) const {
    return is_finite(equation.residual_nm + movement_m_ + variance_m2_ + stiffness_covariance_m_ +
                     offset_covariance_nm2_ + offset_nm_ + offset_variance_nm2_);
}

}  // namespace rsi
