// Evaluation: forces and accelerations at one state, kept for the next step and for the truth.
#pragma once

#include <array>

#include "sil/world/vehicle/equations_of_motion.hpp"
#include "sil/world/vehicle/steering.hpp"
#include "sil/world/vehicle/truth.hpp"
#include "sil/world/vehicle/vector.hpp"

namespace sil {

template <typename Real>
struct BasicWheelEvaluation {
    Real load_n{0.0};
    Real deflection_m{0.0};  // of the tyre, < 0 in the air
    Real spin_acceleration_radps2{0.0};
};

template <typename Real>
struct BasicEvaluation {
    Matrix3Of<Real> rotation{Matrix3Of<Real>::Identity()};  // body axes to earth-fixed
    Vector3Of<Real> road_normal{Vector3Of<Real>::UnitZ()};  // below the CG, earth-fixed
    Vector3Of<Real> heading{
        Vector3Of<Real>::UnitX()};  // body x axis projected on the road plane, earth-fixed
    Vector3Of<Real> tyre_force_body_n{Vector3Of<Real>::Zero()};
    BasicAccelerations<Real> accelerations{};
    std::array<BasicWheelEvaluation<Real>, wheel_count> wheels{};
    BasicRoadWheelAngle<Real> road_wheel{};
    Real steering_wheel_angle_rad{0.0};
    Real suspension_roll_moment_nm{0.0};  // of springs, stops, dampers and anti-roll bars
};
using Evaluation = BasicEvaluation<double>;

}  // namespace sil
