#include "rsi/estimation/robust_least_squares.hpp"

#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr float two_pi = 6.2831853F;

}  // namespace

RobustLeastSquares::Constants::Constants(const Parameters& parameters)
    : forgetting_factor(parameters.forgetting_factor),
      forgetting_growth(1.0F / forgetting_factor),
      disturbance_weight(1.0F -
                         decaying_exponential(two_pi * parameters.disturbance_cutoff_hz * sample_time_s)),
      output_scale_nm(parameters.regression_scale_nm),
      parameter_scale(parameters.initial_roll_centre_deviation_m,
                      parameters.initial_stiffness_deviation_nmprad,
                      parameters.initial_damping_deviation_nmsprad),
      input_scale(parameter_scale / output_scale_nm),
      output_scale_inverse(1.0F / output_scale_nm),
      covariance_limit(parameters.covariance_limit) {}

void RobustLeastSquares::reset() {
    theta_.setZero();
    covariance_.setIdentity();
    disturbance_ = 0.0F;
}

// With g = P(k-1) psi and s = psi^T g, (10) gives P(k) psi / n_s = g / (lambda n_s + s) exactly, so the gain
// of (9) needs no second product. Normalisation divides Y and psi by sqrt(n_s); only n_s itself remains in
// (9) and (10). The part taken off P is symmetric to the last bit, and so P stays: an unsymmetric part of its
// rounding error would never be damped and grow as lambda^-k.
[[gnu::flatten, gnu::noinline]] void RobustLeastSquares::update(const Constants& constants,
                                                                const Regression& regression) {
    const Vector3 psi = regression.psi.cwiseProduct(constants.input_scale);
    const float output = regression.output_nm * constants.output_scale_inverse;

    const Vector3 g = covariance_ * psi;
    const float s = absolute(psi.dot(g));  // negative only by rounding
    const float n_s = 1.0F + s;
    // Without excitation forgetting would let P grow without bound; above the limit nothing is forgotten.
    const bool forgets = !(covariance_.trace() > constants.covariance_limit);
    const float lambda = forgets ? constants.forgetting_factor : 1.0F;
    const float growth = forgets ? constants.forgetting_growth : 1.0F;  // 1 / lambda
    const float divisor_inverse = 1.0F / (lambda * n_s + s);            // of at least lambda

    const float innovation = output - psi.dot(theta_) - disturbance_;
    disturbance_ += constants.disturbance_weight * innovation;
    theta_ += g * (innovation * divisor_inverse);
    covariance_ = (covariance_ - (g * g.transpose()) * divisor_inverse) * growth;

    // No element of P is larger than the largest on its diagonal.
    if (!is_finite(theta_.sum() + covariance_.trace() + disturbance_)) {
        reset();
    }
}

RollCentreEstimate RobustLeastSquares::estimate(const Constants& constants) const {
    const Vector3 theta = theta_.cwiseProduct(constants.parameter_scale);
    RollCentreEstimate estimate;
    estimate.vertical_movement_m = theta.x();
    estimate.stiffness_deviation_nmprad = theta.y();
    estimate.damping_deviation_nmsprad = theta.z();
    estimate.disturbance_nm = disturbance_ * constants.output_scale_nm;
    return estimate;
}

}  // namespace rsi
