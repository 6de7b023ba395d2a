// Equations (8) to (11) in double, written from the paper: full matrices, physical units, normalised by
// dividing Y and psi by sqrt(n_s).
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "rsi/rsi.h"
#include "tests/rsi/support/nominal.hpp"

namespace rsi_test {

class ReferenceLeastSquares {
 public:
    explicit ReferenceLeastSquares(const rsi_parameters& parameters)
        : lambda_(static_cast<double>(parameters.forgetting_factor)),
          alpha_(1.0 - std::exp(-2.0 * pi * static_cast<double>(parameters.disturbance_cutoff_hz) * 0.01)) {
        // P is in units of theta squared per unit of the scaled Y squared, hence the division by the scale.
        const double scale = static_cast<double>(parameters.regression_scale_nm);
        const Eigen::Vector3d deviation(static_cast<double>(parameters.initial_roll_centre_deviation_m),
                                        static_cast<double>(parameters.initial_stiffness_deviation_nmprad),
                                        static_cast<double>(parameters.initial_damping_deviation_nmsprad));
        P_ = (deviation / scale).cwiseAbs2().asDiagonal();
    }

    void update(double Y, const Eigen::Vector3d& psi) {
        const double n_s = 1.0 + psi.dot(P_ * psi);
        const double Y_n = Y / std::sqrt(n_s);
        const double d_n = d_ / std::sqrt(n_s);
        const Eigen::Vector3d psi_n = psi / std::sqrt(n_s);

        const Eigen::Vector3d P_psi = P_ * psi_n;
        const double denominator = lambda_ + psi_n.dot(P_psi);
        P_ = (P_ - P_psi * P_psi.transpose() / denominator) / lambda_;
        P_ = 0.5 * (P_ + P_.transpose().eval());  // keeps rounding from making it unsymmetric

        const double error = Y - psi.dot(theta_) - d_;
        theta_ += P_ * psi_n * (Y_n - psi_n.dot(theta_) - d_n);
        d_ += alpha_ * error;
    }

    const Eigen::Vector3d& theta() const { return theta_; }
    double disturbance_nm() const { return d_; }
    const Eigen::Matrix3d& covariance() const { return P_; }

 private:
    double lambda_;
    double alpha_;
    Eigen::Matrix3d P_{Eigen::Matrix3d::Zero()};
    Eigen::Vector3d theta_{Eigen::Vector3d::Zero()};
    double d_{0.0};
};

}  // namespace rsi_test
