#include "rsi/estimation/robust_least_squares.hpp"

#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr float two_pi = 6.2831853F;

}  // namespace

void RobustLeastSquares::init(const Parameters& parameters) {
    forgetting_factor_ = parameters.forgetting_factor;
    forgetting_growth_ = 1.0F / forgetting_factor_;
    disturbance_weight_ =
        1.0F - decaying_exponential(two_pi * parameters.disturbance_cutoff_hz * sample_time_s);
    output_scale_nm_ = parameters.regression_scale_nm;
    parameter_scale_ << parameters.initial_roll_centre_deviation_m,
        parameters.initial_stiffness_deviation_nmprad, parameters.initial_damping_deviation_nmsprad;
    input_scale_ = parameter_scale_ / output_scale_nm_;
    output_scale_inverse_ = 1.0F / output_scale_nm_;
    covariance_limit_ = parameters.covariance_limit;
    reset();
}

void RobustLeastSquares::reset() {
    theta_.setZero();
    covariance_ = Covariance{};
    disturbance_ = 0.0F;
}

// With g = P(k-1) psi and s = psi^T g, (10) gives P(k) psi / n_s = g / (lambda n_s + s) exactly, so the gain
// of (9) needs no second product. Normalisation divides Y and psi by sqrt(n_s); only n_s itself remains in
// (9) and (10).
[[gnu::flatten, gnu::noinline]] void RobustLeastSquares::update(const Regression& regression) {
    const Eigen::Vector3f psi = regression.psi.cwiseProduct(input_scale_);
    const float output = regression.output_nm * output_scale_inverse_;

    const Eigen::Vector3f g = covariance_ * psi;
    const float s = absolute(dot(psi, g));  // negative only by rounding
    const float n_s = 1.0F + s;
    // Without excitation forgetting would let P grow without bound; above the limit nothing is forgotten.
    const bool forgets = !(covariance_.trace() > covariance_limit_);
    const float lambda = forgets ? forgetting_factor_ : 1.0F;
    const float growth = forgets ? forgetting_growth_ : 1.0F;  // 1 / lambda
    const float divisor = lambda * n_s + s;                    // at least lambda

    const float innovation = output - dot(psi, theta_) - disturbance_;
    disturbance_ += disturbance_weight_ * innovation;
    theta_ += g * (innovation / divisor);
    update_covariance(g, divisor, growth);

    // No element of P is larger than the largest on its diagonal.
    if (!is_finite(theta_.sum() + covariance_.trace() + disturbance_)) {
        reset();
    }
}

// (10), in six elements.
void RobustLeastSquares::update_covariance(const Eigen::Vector3f& g, float divisor, float growth) {
    const Eigen::Vector3f u = g / divisor;
    covariance_.p00 = (covariance_.p00 - u.x() * g.x()) * growth;
    covariance_.p01 = (covariance_.p01 - u.x() * g.y()) * growth;
    covariance_.p02 = (covariance_.p02 - u.x() * g.z()) * growth;
    covariance_.p11 = (covariance_.p11 - u.y() * g.y()) * growth;
    covariance_.p12 = (covariance_.p12 - u.y() * g.z()) * growth;
    covariance_.p22 = (covariance_.p22 - u.z() * g.z()) * growth;
}

RollCentreEstimate RobustLeastSquares::estimate() const {
    const Eigen::Vector3f theta = theta_.cwiseProduct(parameter_scale_);
    RollCentreEstimate estimate;
    estimate.vertical_movement_m = theta.x();
    estimate.stiffness_deviation_nmprad = theta.y();
    estimate.damping_deviation_nmsprad = theta.z();
    estimate.disturbance_nm = disturbance_ * output_scale_nm_;
    return estimate;
}

}  // namespace rsi
