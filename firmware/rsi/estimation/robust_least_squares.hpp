// Recursive least squares with disturbance observer and normalisation (RLSDA), equations (8) to (11).
#pragma once

#include "rsi/estimation/regression.hpp"
#include "rsi/estimation/roll_centre_estimate.hpp"
#include "rsi/numeric/matrix.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Works in scaled units: Y divided by the regression scale, theta by the square roots of the diagonal of
// P(0), because the normalisation n_s = 1 + psi^T P psi depends on the units.
class RobustLeastSquares {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // The parameters from now on; what has been learnt stays, so their units must be the same.
    [[gnu::cold]] void tune(const Parameters& parameters);
    [[gnu::cold, gnu::noinline]] void reset();

    // One sample. A step that would leave anything not finite resets the estimator instead.
    void update(const Regression& regression);

    RollCentreEstimate estimate() const;

    // In scaled units: P(0) is the unit matrix.
    const Matrix3& covariance() const { return covariance_; }

 private:
    float forgetting_factor_{1.0F};
    float forgetting_growth_{1.0F};   // its inverse
    float disturbance_weight_{0.0F};  // alpha of (11)
    float output_scale_nm_{1.0F};
    Vector3 parameter_scale_{Vector3::Ones()};
    Vector3 input_scale_{Vector3::Ones()};  // parameter scale over output scale
    float output_scale_inverse_{1.0F};
    float covariance_limit_{1.0F};

    Vector3 theta_{Vector3::Zero()};
    Matrix3 covariance_{Matrix3::Identity()};
    float disturbance_{0.0F};
};

}  // namespace rsi
