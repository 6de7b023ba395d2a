#include "rsi/estimation/consider_kalman.hpp"

#include "rsi/measurement/plausible_motion.hpp"
#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded_functions.hpp"
#include "rsi/numeric/square.hpp"
#include "rsi/numeric/square_root.hpp"

namespace rsi {
namespace {

// Assumed errors of calibration and sensors, one standard deviation each.
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

ConsiderKalman::Constants::Constants(const Parameters& parameters)
    : equation(parameters),
      prior_variance_m2(square(parameters.roll_centre_prior_deviation_m)),
      reversion(1.0F - decaying_exponential(sample_time_s / parameters.roll_centre_reversion_s)),
      steady_reversion(steady_share * reversion),
      limit_m(parameters.roll_centre_limit_m),
      excitation_threshold_n(parameters.sprung_mass_kg * parameters.excitation_threshold_mps2),
      freeze_level(parameters.freeze_level),
      noise_nm2(correlation * square(noise_nm)),
      damping_noise_nm2s2(correlation * square(damping_error * parameters.roll_damping_nmsprad)) {
    const float nm_per_mps2 = parameters.sprung_mass_kg * roll_arm_m(parameters);
    offset_prior_nm2 = square(offset_prior_mps2 * nm_per_mps2);
    offset_drift_nm2 = square(offset_drift_mps2_per_root_s * nm_per_mps2) * sample_time_s;
}

void ConsiderKalman::reset(const Constants& constants) {
    reset_signals();
    state_.setZero();
    covariance_.setZero();
    covariance_(movement, movement) = constants.prior_variance_m2;
    covariance_(stiffness, stiffness) = square(stiffness_error);
    covariance_(offset, offset) = constants.offset_prior_nm2;
}

RollCentreEstimate ConsiderKalman::update(const Constants& constants, const Vehicle& vehicle,
                                          const Measurement& measured, float extended_rsi, float speed_mps) {
    const RollEquation equation = equation_.update(constants.equation, vehicle, measured);
    const bool speed_changes = changes_speed(speed_mps);
    // An angle that the observer made with the nominal model says nothing about dh.
    const bool held = (extended_rsi > constants.freeze_level) || speed_changes ||
                      (measured.roll_source == RSI_ROLL_OBSERVER);
    const float force_n = absolute(equation.lateral_force_n);
    const bool excited = force_n > constants.excitation_threshold_n;
    // A turn cannot tell an unknown offset from dh.
    const bool offset_known = covariance_(offset, offset) < square(learnt_share) * constants.offset_prior_nm2;
    const bool learns = equation.settled && excited && offset_known && !held;
    pass_time(constants, equation, excited, held);
    if (learns) {
        learn(movement, innovation(constants, equation));
    } else if (equation.settled && (force_n < straight_share * constants.excitation_threshold_n) &&
               (absolute(equation.roll_rate_radps) < straight_roll_rate_radps)) {
        learn(offset, innovation(constants, equation));
    } else {
        // Between the two, they cannot be separated.
    }
    keep_in_bounds(constants);
    RollCentreEstimate estimate;
    if (!all_finite(equation)) {
        reset(constants);
        estimate.deviation_m = square_root(covariance_(movement, movement));
        estimate.frozen = true;
        return estimate;
    }
    estimate.vertical_movement_m = state_(movement);
    estimate.stiffness_deviation_nmprad = equation.stiffness_deviation_nmprad;
    estimate.disturbance_nm = equation.residual_nm - equation.lateral_force_n * state_(movement);
    estimate.inertia_moment_nm = -equation.inertia_moment_nm;
    estimate.deviation_m = square_root(covariance_(movement, movement));
    estimate.frozen = !learns;
    return estimate;
}

void ConsiderKalman::pass_time(const Constants& constants, const RollEquation& equation, bool excited,
                               bool held) {
    const float rolled = absolute(equation.roll_rate_radps) * (sample_time_s / memory_angle_rad);
    const float forgotten = (excited ? constants.steady_reversion : constants.reversion) + rolled;
    const float retention = 1.0F - smaller(forgotten, 0.5F);
    float& variance_m2 = covariance_(movement, movement);
    variance_m2 =
        constants.prior_variance_m2 + square(retention) * (variance_m2 - constants.prior_variance_m2);
    covariance_(offset, offset) =
        smaller(covariance_(offset, offset) + constants.offset_drift_nm2, constants.offset_prior_nm2);
    if (!held) {
        state_(movement) *= retention;
        for (const Eigen::Index other : {stiffness, offset}) {
            covariance_(movement, other) *= retention;
            covariance_(other, movement) *= retention;
        }
    }
}

// A speed that is not available does not hold.
bool ConsiderKalman::changes_speed(float speed_mps) {
    if (!is_within(speed_mps, 0.0F, largest_plausible_speed_mps)) {
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

ConsiderKalman::Innovation ConsiderKalman::innovation(const Constants& constants,
                                                      const RollEquation& equation) const {
    const float noise = constants.noise_nm2 +
                        constants.damping_noise_nm2s2 * square(equation.roll_rate_radps) +
                        correlation * square(inertia_error) * square(equation.inertia_moment_nm);
    const Vector3 h{equation.lateral_force_n, equation.stiffness_moment_nm, 1.0F};
    Innovation innovation;
    innovation.value_nm = equation.residual_nm - h.dot(state_);
    innovation.covariance = covariance_ * h;
    // Positive semidefinite in exact numbers; rounding must not undercut the noise.
    innovation.variance_nm2 = larger(h.dot(innovation.covariance) + noise, constants.noise_nm2);
    const float size = square(innovation.value_nm);
    const float usual = outlier_variances * innovation.variance_nm2;
    innovation.weight = (size > usual) ? usual / size : 1.0F;
    return innovation;
}

// One element of the state; the others are considered (Schmidt): their gain is zero.
void ConsiderKalman::learn(Eigen::Index which, const Innovation& innovation) {
    const Vector3& c = innovation.covariance;
    Vector3 gain = Vector3::Zero();
    gain(which) = innovation.weight * c(which) / innovation.variance_nm2;
    state_ += gain * innovation.value_nm;
    covariance_ += gain * (gain.transpose() * innovation.variance_nm2 - c.transpose()) - c * gain.transpose();
}

void ConsiderKalman::keep_in_bounds(const Constants& constants) {
    state_(movement) = clamp_magnitude(state_(movement), constants.limit_m);
    covariance_(movement, movement) =
        clamp(covariance_(movement, movement), square(smallest_deviation_m), constants.prior_variance_m2);
    covariance_(offset, offset) = larger(covariance_(offset, offset), constants.offset_drift_nm2);
}

// Every signal of the equation is in its residual. A sum is not finite when a summand is not.
bool ConsiderKalman::all_finite(const RollEquation& equation) const {
    return is_finite(equation.residual_nm + state_.sum() + covariance_.sum());
}

}  // namespace rsi
