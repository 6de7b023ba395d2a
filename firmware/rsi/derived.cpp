#include "rsi/derived.hpp"

#include "rsi/model/critical_roll_angle.hpp"
#include "rsi/model/vehicle_lengths.hpp"

namespace rsi {

Iterated iterate(const Parameters& parameters) {
    return {steady_observer_gains(upright_roll(parameters), observer_noise(parameters)),
            critical_roll_angle_rad(parameters)};
}

Derived::Derived(const Parameters& parameters, const Iterated& iterated)
    : static_stability_factor(rsi::static_stability_factor(parameters)),
      observer_weight(1.0F + parameters.observer_margin),
      load_transfer_inertial_weight(parameters.load_transfer_inertial_weight),
      vehicle(parameters),
      measurement(parameters, iterated.gains),
      motion_filter(parameters),
      estimator(parameters),
      steering_demand(parameters),
      lateral_response(parameters),
      moment_arm_error(parameters),
      predictor(parameters),
      load_adaptation(parameters),
      comparison(parameters, iterated.critical_roll_angle_rad),
      warning_indicator(parameters),
      warning(parameters) {}

}  // namespace rsi
