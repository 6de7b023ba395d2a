// A matrix whose size is known at run time only: its elements are on the heap.
// Caught by: dynamic-matrix
#include <Eigen/Core>

#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

float float_violation(float value) {
    const Eigen::VectorXf values = Eigen::VectorXf::Constant(3, value);
    return values.sum();
}

}  // namespace planted
