// Driver input: what hands and feet ask of the vehicle.
#pragma once

namespace sil {

struct DriverInput {
    double steering_wheel_angle_rad{0.0};  // > 0 turns left
    double drive_force_n{0.0};             // asked at the wheels, all together; below 0 is engine braking
    double brake{0.0};                     // 0 (released) to 1 (full)
};

}  // namespace sil
