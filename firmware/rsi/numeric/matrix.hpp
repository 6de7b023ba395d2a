// Vectors and matrices: Eigen's, of fixed size.
//
// Without alignment of their own, so that a structure that holds them has one layout whatever Eigen is told.
// Their arithmetic stands in source files, which are compiled with EIGEN_DONT_VECTORIZE: vector units sum in
// another order and may fuse a*b+c, and the bits would differ from target to target.
#pragma once

#include <Eigen/Core>

namespace rsi {

using Vector3 = Eigen::Matrix<float, 3, 1, Eigen::DontAlign>;
using Vector4 = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;
using Matrix3 = Eigen::Matrix<float, 3, 3, Eigen::DontAlign>;
using Matrix4 = Eigen::Matrix<float, 4, 4, Eigen::DontAlign>;

}  // namespace rsi
