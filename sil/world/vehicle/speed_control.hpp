// Driver's speed control: the right foot that holds a speed, or lets go.
#pragma once

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

enum class SpeedPolicy { held, off_throttle };

// Proportional and integral control of the drive force; the integral stands still while the force is at its
// limit.
class SpeedControl {
 public:
    explicit SpeedControl(const VehicleParameters& parameters);

    void reset() { integral_n_ = 0.0; }

    // Drive force to ask for, from -engine braking to the vehicle's limit.
    double drive_force_n(SpeedPolicy policy, double wanted_speed_mps, double speed_mps, double step_s);

 private:
    double proportional_nspm_;
    double integral_npm_;
    double lower_limit_n_;
    double upper_limit_n_;
    double drag_n_pm2ps2_;
    double rolling_n_;
    double integral_n_{0.0};
};

}  // namespace sil
