// Recursive least squares with disturbance observer and normalisation (RLSDA), equations (8) to (11).
#pragma once

#include "rsi/numeric/eigen.hpp"

#include "rsi/estimation/regression.hpp"
#include "rsi/estimation/roll_centre_estimate.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Symmetric 3x3 matrix in six elements, so rounding cannot make it unsymmetric: with nine, the unsymmetric
// part of the rounding error is never damped and grows as lambda^-k.
struct Covariance {
    float p00{1.0F}, p01{0.0F}, p02{0.0F}, p11{1.0F}, p12{0.0F}, p22{1.0F};

    Eigen::Vector3f operator*(const Eigen::Vector3f& v) const {
        return Eigen::Vector3f{p00 * v.x() + p01 * v.y() + p02 * v.z(),
                               p01 * v.x() + p11 * v.y() + p12 * v.z(),
                               p02 * v.x() + p12 * v.y() + p22 * v.z()};
    }
    float trace() const { return p00 + p11 + p22; }
};

// Works in scaled units: Y divided by the regression scale, theta by the square roots of the diagonal of
// P(0), because the normalisation n_s = 1 + psi^T P psi depends on the units.
class RobustLeastSquares {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);
    [[gnu::cold, gnu::noinline]] void reset();

    // One sample. A step that would leave anything not finite resets the estimator instead.
    void update(const Regression& regression);

    RollCentreEstimate estimate() const;

    // In scaled units: P(0) is the unit matrix.
    const Covariance& covariance() const { return covariance_; }

 private:
    void update_covariance(const Eigen::Vector3f& g, float divisor, float growth);

    float forgetting_factor_{1.0F};
    float forgetting_growth_{1.0F};   // its inverse
    float disturbance_weight_{0.0F};  // alpha of (11)
    float output_scale_nm_{1.0F};
    Eigen::Vector3f parameter_scale_{Eigen::Vector3f::Ones()};
    Eigen::Vector3f input_scale_{Eigen::Vector3f::Ones()};  // parameter scale over output scale
    float output_scale_inverse_{1.0F};
    float covariance_limit_{1.0F};

    Eigen::Vector3f theta_{Eigen::Vector3f::Zero()};
    Covariance covariance_{};
    float disturbance_{0.0F};
};

}  // namespace rsi
