// A matrix of a size that is written in place: -1 would make it one on the heap.
// Caught by: dynamic-matrix
#include <Eigen/Core>

#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

float float_violation(float value) {
    const Eigen::Matrix<float, -1, 1> values = Eigen::Matrix<float, -1, 1>::Constant(3, 1, value);
    return values.sum();
}

}  // namespace planted
