// Least squares: a linear fit with prior knowledge, its standard errors and its condition.
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace sil {

// Prior of an unknown.
struct Prior {
    double mean;
    double deviation;  // > 0
};

struct LinearFit {
    Eigen::VectorXd value;
    Eigen::VectorXd deviation;     // standard errors
    double condition_number{1.0};  // of the data alone, columns scaled to length 1; infinite when singular
};

// y = psi^T theta. Rows come with the standard deviation of what the model cannot explain, and with how many
// independent observations each counts for: neighbouring samples of a drive are not independent.
class LinearProblem {
 public:
    explicit LinearProblem(std::vector<Prior> priors);

    void add(const Eigen::VectorXd& psi, double y, double deviation, double independence);

    LinearFit solve() const;

 private:
    std::vector<Prior> priors_;
    Eigen::MatrixXd information_;
    Eigen::VectorXd moment_;
};

}  // namespace sil
