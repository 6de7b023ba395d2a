// Driver input: what hands and feet ask of the vehicle.
#pragma once

namespace sil {

template <typename Real>
struct BasicDriverInput {
    Real steering_wheel_angle_rad{0.0};  // > 0 turns left
    Real drive_force_n{0.0};             // asked at the wheels, all together; below 0 is engine braking
    Real brake{0.0};                     // 0 (released) to 1 (full)
};
using DriverInput = BasicDriverInput<double>;

}  // namespace sil
