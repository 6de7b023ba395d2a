// Vectors and matrices: Eigen's, of fixed size.
//
// Without alignment of their own, so that a structure that holds them has one layout whatever options Eigen
// is compiled with. Their arithmetic stands in source files, which are compiled with EIGEN_DONT_VECTORIZE:
// vector units sum in another order and may fuse a*b+c, and the bits would differ from target to target.
// Eigen's other options are set here, and not by flags, so that no build can leave one out: no allocation,
// streams, threads or run-time assertions, which would need assert(). Nothing else in the firmware includes
// Eigen.
#pragma once

#include "rsi/language.hpp"

#ifndef EIGEN_MPL2_ONLY
#define EIGEN_MPL2_ONLY
#endif
#ifndef EIGEN_NO_DEBUG
#define EIGEN_NO_DEBUG
#endif
#ifndef EIGEN_NO_MALLOC
#define EIGEN_NO_MALLOC
#endif
#ifndef EIGEN_NO_IO
#define EIGEN_NO_IO
#endif
#ifndef EIGEN_DONT_PARALLELIZE
#define EIGEN_DONT_PARALLELIZE
#endif

#include <Eigen/Core>

namespace rsi {

using Vector2 = Eigen::Matrix<float, 2, 1, Eigen::DontAlign>;
using Vector3 = Eigen::Matrix<float, 3, 1, Eigen::DontAlign>;
using Vector4 = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;
using Matrix2 = Eigen::Matrix<float, 2, 2, Eigen::DontAlign>;
using Matrix3 = Eigen::Matrix<float, 3, 3, Eigen::DontAlign>;
using Matrix4 = Eigen::Matrix<float, 4, 4, Eigen::DontAlign>;
using Matrix5x3 = Eigen::Matrix<float, 5, 3, Eigen::DontAlign>;

}  // namespace rsi
