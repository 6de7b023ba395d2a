#include "sil/studies/identification/least_squares.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace sil {
namespace {

double condition_of(const Eigen::MatrixXd& information) {
    const Eigen::VectorXd length = information.diagonal().cwiseSqrt();
    if (length.minCoeff() <= 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    const Eigen::MatrixXd scaled =
        length.cwiseInverse().asDiagonal() * information * length.cwiseInverse().asDiagonal();
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{scaled}.eigenvalues();
    if (eigenvalues.minCoeff() <= 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    return std::sqrt(eigenvalues.maxCoeff() / eigenvalues.minCoeff());
}

}  // namespace

LinearProblem::LinearProblem(std::vector<Prior> priors)
    : priors_{std::move(priors)},
      information_{Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(priors_.size()),
                                         static_cast<Eigen::Index>(priors_.size()))},
      moment_{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(priors_.size()))} {}

// In units of the prior's deviations and counted from its means, so that all unknowns are of one size.
void LinearProblem::add(const Eigen::VectorXd& psi, double y, double deviation, double independence) {
    Eigen::VectorXd scaled = psi;
    double rest = y;
    for (Eigen::Index i = 0; i < psi.size(); ++i) {
        const Prior& prior = priors_[static_cast<std::size_t>(i)];
        rest -= psi[i] * prior.mean;
        scaled[i] *= prior.deviation;
    }
    const double weight = independence / (deviation * deviation);
    information_ += weight * scaled * scaled.transpose();
    moment_ += weight * rest * scaled;
}

LinearFit LinearProblem::solve() const {
    const Eigen::Index count = moment_.size();
    const Eigen::MatrixXd covariance = (information_ + Eigen::MatrixXd::Identity(count, count))
                                           .llt()
                                           .solve(Eigen::MatrixXd::Identity(count, count));
    LinearFit fit;
    fit.value = covariance * moment_;
    fit.deviation = covariance.diagonal().cwiseSqrt();
    for (Eigen::Index i = 0; i < count; ++i) {
        const Prior& prior = priors_[static_cast<std::size_t>(i)];
        fit.value[i] = prior.mean + prior.deviation * fit.value[i];
        fit.deviation[i] *= prior.deviation;
    }
    fit.condition_number = condition_of(information_);
    return fit;
}

}  // namespace sil
