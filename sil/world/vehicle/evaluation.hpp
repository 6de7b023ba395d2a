// Evaluation: forces and accelerations at one state, kept for the next step and for the truth.
#pragma once

#include <array>

#include "sil/world/vehicle/equations_of_motion.hpp"
#include "sil/world/vehicle/steering.hpp"
#include "sil/world/vehicle/truth.hpp"
#include "sil/world/vehicle/vector.hpp"

namespace sil {

struct WheelEvaluation {
    double load_n{0.0};
    double deflection_m{0.0};  // of the tyre, < 0 in the air
    double spin_acceleration_radps2{0.0};
};

struct Evaluation {
    Matrix3 rotation{Matrix3::Identity()};  // body axes to earth-fixed
    Vector3 road_normal{Vector3::UnitZ()};  // below the CG, earth-fixed
    Vector3 heading{Vector3::UnitX()};      // body x axis projected on the road plane, earth-fixed
    Vector3 tyre_force_body_n{Vector3::Zero()};
    Accelerations accelerations{};
    std::array<WheelEvaluation, wheel_count> wheels{};
    RoadWheelAngle road_wheel{};
    double steering_wheel_angle_rad{0.0};
    double suspension_roll_moment_nm{0.0};  // of springs, stops, dampers and anti-roll bars
};

}  // namespace sil
