// Steady steering: how far the handwheel must be turned for a lateral acceleration.
#pragma once

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Its value in the linear single-track model in a steady turn: delta = a (l / v^2 + K).
class SteadySteering {
 public:
    SteadySteering(const VehicleParameters& vehicle, double understeer_gradient_s2pm)
        : ratio_{vehicle.steering.ratio},
          wheelbase_m_{wheelbase_m(vehicle.geometry)},
          understeer_gradient_s2pm_{understeer_gradient_s2pm} {}

    // `speed_mps`: not zero.
    double handwheel_rad(double acceleration_mps2, double speed_mps) const {
        return ratio_ * acceleration_mps2 *
               (wheelbase_m_ / (speed_mps * speed_mps) + understeer_gradient_s2pm_);
    }

 private:
    double ratio_;
    double wheelbase_m_;
    double understeer_gradient_s2pm_;
};

}  // namespace sil
