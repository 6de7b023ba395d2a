// Eigen as the component uses it: fixed sizes, no allocation, streams, threads or run-time assertions (the compiler
// checks the sizes). They are set here and not by flags, so that no build can leave one out: without EIGEN_NO_DEBUG the
// library would need assert(). No other header or source of the firmware includes Eigen. None of them changes a layout,
// and Vector3f needs no alignment, so a caller may include Eigen before this with settings of its own.
#pragma once

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

// In place of Eigen's own dot(), whose order of addition depends on the processor's SIMD unit: on 64-bit Arm its last
// bits were others. This is the order without such a unit.
inline float dot(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return a.x() * b.x() + (a.y() * b.y() + a.z() * b.z());
}

}  // namespace rsi
