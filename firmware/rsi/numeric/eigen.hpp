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
