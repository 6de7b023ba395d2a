// Driver input: what hands and feet ask of the vehicle, and what disturbs it meanwhile.
#pragma once

#include "sil/world/vehicle/disturbance.hpp"

namespace sil {

template <typename Real>
struct BasicDriverInput {
    Real steering_wheel_angle_rad{0.0};  // > 0 turns left
    Real drive_force_n{0.0};             // asked at the wheels, all together; below 0 is engine braking
    Real brake{0.0};                     // 0 (released) to 1 (full)
    BasicDisturbance<Real> disturbance{};
};
using DriverInput = BasicDriverInput<double>;

}  // namespace sil
