// Driver's speed control.
#include "sil/world/vehicle/speed_control.hpp"

#include <algorithm>
#include <cmath>

#include "sil/world/vehicle/vector.hpp"

namespace sil {
namespace {

constexpr double bandwidth_radps = 3.0;
constexpr double integral_time_s = 1.0;

}  // namespace

SpeedControl::SpeedControl(const VehicleParameters& parameters)
    : proportional_nspm_{bandwidth_radps * total_mass_kg(parameters)},
      integral_npm_{proportional_nspm_ / integral_time_s},
      lower_limit_n_{-parameters.driveline.engine_braking_n},
      upper_limit_n_{parameters.driveline.drive_force_limit_n},
      drag_n_pm2ps2_{0.5 * air_density_kgpm3 * parameters.aerodynamics.drag_area_m2},
      rolling_n_{parameters.tyre.rolling_resistance * total_mass_kg(parameters) * gravity_mps2} {}

double SpeedControl::drive_force_n(SpeedPolicy policy, double wanted_speed_mps, double speed_mps,
                                   double step_s) {
    if (policy == SpeedPolicy::off_throttle) {
        integral_n_ = 0.0;
        return speed_mps > 0.5 ? lower_limit_n_ : 0.0;
    }
    const double error = wanted_speed_mps - speed_mps;
    const double straight = rolling_n_ + drag_n_pm2ps2_ * speed_mps * std::abs(speed_mps);
    const double force = straight + proportional_nspm_ * error + integral_n_;
    const double limited = std::clamp(force, lower_limit_n_, upper_limit_n_);
    if (force == limited) {
        integral_n_ += step_s * integral_npm_ * error;
    }
    return limited;
}

}  // namespace sil
