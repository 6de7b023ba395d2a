// Vector types: short names for the fixed-size Eigen types that the vehicle uses.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace sil {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

inline constexpr double gravity_mps2 = 9.80665;

}  // namespace sil
