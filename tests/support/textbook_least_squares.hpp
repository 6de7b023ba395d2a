// Textbook least squares: (9) and (10) as a book writes them, with matrices of dynamic size and general
// products. Reference for the firmware's own form; it needs the heap.
#pragma once

#include <Eigen/Core>

#include "rsi/estimation/regression.hpp"
#include "rsi/types.hpp"

namespace rsi_test {

class TextbookLeastSquares {
 public:
    explicit TextbookLeastSquares(const rsi::Parameters& p)
        : lambda_(p.forgetting_factor),
          scale_(p.regression_scale_nm),
          theta_(Eigen::VectorXf::Zero(3)),
          widths_(3),
          P_(Eigen::MatrixXf::Identity(3, 3)) {
        widths_ << p.initial_roll_centre_deviation_m, p.initial_stiffness_deviation_nmprad,
            p.initial_damping_deviation_nmsprad;
    }

    void update(const rsi::Regression& regression) {
        const Eigen::VectorXf psi = Eigen::VectorXf(regression.psi).cwiseProduct(widths_) / scale_;
        const float n_s = 1.0F + (psi.transpose() * P_ * psi).value();
        const float e = regression.output_nm / scale_ - psi.dot(theta_);
        P_ = (P_ - P_ * psi * psi.transpose() * P_ / (lambda_ * n_s + (psi.transpose() * P_ * psi).value())) /
             lambda_;
        theta_ += P_ * psi * e / n_s;
    }

    const Eigen::VectorXf& theta() const { return theta_; }

 private:
    float lambda_;
    float scale_;
    Eigen::VectorXf theta_;
    Eigen::VectorXf widths_;
    Eigen::MatrixXf P_;
};

}  // namespace rsi_test
