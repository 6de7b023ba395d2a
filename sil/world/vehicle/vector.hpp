// Vector types: short names for the fixed-size Eigen types that the vehicle uses, and the products of which
// recorded results depend on every bit.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sil/world/vehicle/number.hpp"

namespace sil {

// `Real` is double for one vehicle, and Lanes for several that are computed at once (lanes.hpp).
template <typename Real>
using Vector3Of = Eigen::Matrix<Real, 3, 1>;
template <typename Real>
using Vector6Of = Eigen::Matrix<Real, 6, 1>;
template <typename Real>
using Matrix3Of = Eigen::Matrix<Real, 3, 3>;
// Not aligned, so that nothing lies between the numbers of a vehicle.
template <typename Real>
using QuaternionOf = Eigen::Quaternion<Real, Eigen::DontAlign>;

using Vector3 = Vector3Of<double>;
using Matrix3 = Matrix3Of<double>;
using Vector6 = Vector6Of<double>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

inline constexpr double gravity_mps2 = 9.80665;

// Sums in a stated order. Eigen's own products add in an order that depends on the number type and on the
// processor's registers; these add as Eigen does with doubles in registers of two.

template <typename Left, typename Right>
typename Left::Scalar dot3(const Left& a, const Right& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Real>
Real dot6(const Vector6Of<Real>& a, const Vector6Of<Real>& b) {
    return (a[0] * b[0] + (a[2] * b[2] + a[4] * b[4])) + (a[1] * b[1] + (a[3] * b[3] + a[5] * b[5]));
}

template <typename Real>
Real norm3(const Vector3Of<Real>& a) {
    return number::sqrt(dot3(a, a));
}

// M v.
template <typename Real>
Vector3Of<Real> product(const Matrix3Of<Real>& m, const Vector3Of<Real>& v) {
    return {m(0, 0) * v[0] + m(0, 1) * v[1] + m(0, 2) * v[2],
            m(1, 0) * v[0] + m(1, 1) * v[1] + m(1, 2) * v[2],
            m(2, 0) * v[0] + (m(2, 1) * v[1] + m(2, 2) * v[2])};
}

// M^T v.
template <typename Real>
Vector3Of<Real> transposed_product(const Matrix3Of<Real>& m, const Vector3Of<Real>& v) {
    return {dot3(m.col(0), v), dot3(m.col(1), v), dot3(m.col(2), v)};
}

// First `b`, then `a`.
template <typename Real>
QuaternionOf<Real> product(const QuaternionOf<Real>& a, const QuaternionOf<Real>& b) {
    return {(a.w() * b.w() - a.y() * b.y()) - (a.z() * b.z() + a.x() * b.x()),
            (a.w() * b.x() + a.y() * b.z()) - (a.z() * b.y() - a.x() * b.w()),
            (a.w() * b.y() + a.y() * b.w()) + (a.z() * b.x() - a.x() * b.z()),
            (a.w() * b.z() - a.y() * b.x()) + (a.z() * b.w() + a.x() * b.y())};
}

template <typename Real>
QuaternionOf<Real> normalised(const QuaternionOf<Real>& q) {
    const Real length = number::sqrt((q.x() * q.x() + q.z() * q.z()) + (q.y() * q.y() + q.w() * q.w()));
    return {q.w() / length, q.x() / length, q.y() / length, q.z() / length};
}

}  // namespace sil
