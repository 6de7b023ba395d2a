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
    // Estimates are in the units of these.
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        float forgetting_factor{};
        float forgetting_growth{};   // its inverse
        float disturbance_weight{};  // alpha of (11)
        float output_scale_nm{};
        Vector3 parameter_scale{Vector3::Zero()};
        Vector3 input_scale{Vector3::Zero()};  // parameter scale over output scale
        float output_scale_inverse{};
        float covariance_limit{};
    };

    [[gnu::cold, gnu::noinline]] void reset();

    // One sample. A step that would leave anything not finite resets the estimator instead.
    void update(const Constants& constants, const Regression& regression);

    RollCentreEstimate estimate(const Constants& constants) const;

    // In scaled units: P(0) is the unit matrix.
    const Matrix3& covariance() const { return covariance_; }

 private:
    Vector3 theta_{Vector3::Zero()};
    Matrix3 covariance_{Matrix3::Identity()};
    float disturbance_{};
};

}  // namespace rsi
