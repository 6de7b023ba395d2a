// Tyre forces; the Magic Formula after Pacejka, both slips combined on one friction ellipse.
#include "sil/world/vehicle/tyre.hpp"

#include <algorithm>
#include <cmath>

namespace sil {
namespace {

constexpr double reference_load_n = 6000.0;
constexpr double smallest_friction = 0.05;
// Below this speed relaxation goes on as if at it, so that a standing vehicle comes to rest.
constexpr double smallest_relaxation_speed_mps = 0.5;

}  // namespace

Tyre::Tyre(const TyreParameters& parameters, double friction_factor)
    : parameters_{parameters},
      friction_at_no_load_{parameters.friction * friction_factor *
                           (1.0 + parameters.friction_load_sensitivity)},
      friction_slope_pn_{-parameters.friction * friction_factor * parameters.friction_load_sensitivity /
                         reference_load_n} {}

double Tyre::vertical_force_n(double deflection_m, double deflection_rate_mps) const {
    if (deflection_m <= 0.0) {
        return 0.0;
    }
    return std::max(0.0, parameters_.vertical_stiffness_npm * deflection_m +
                             parameters_.vertical_damping_nspm * deflection_rate_mps);
}

double Tyre::friction(double load_n) const {
    return std::max(smallest_friction, friction_at_no_load_ + friction_slope_pn_ * load_n);
}

double Tyre::cornering_stiffness_nprad(double load_n) const {
    // sin(2 atan(x)) = 2 x / (1 + x^2)
    const double relative_load = load_n / parameters_.cornering_stiffness_load_n;
    return parameters_.cornering_stiffness_nprad * 2.0 * relative_load /
           (1.0 + relative_load * relative_load);
}

TyreForces Tyre::forces(const TyreSlip& slip, double load_n, double friction_factor, double camber) const {
    if (load_n <= 0.0) {
        return {};
    }
    const double peak_n = friction(load_n) * friction_factor * load_n;
    if (peak_n <= 0.0) {
        return {};
    }
    const double stiffness = cornering_stiffness_nprad(load_n);
    const double linear_lateral = stiffness * slip.lateral - parameters_.camber_thrust_prad * load_n * camber;
    const double linear_longitudinal = parameters_.slip_stiffness_ratio * stiffness * slip.longitudinal;
    const double linear =
        std::sqrt(linear_lateral * linear_lateral + linear_longitudinal * linear_longitudinal);
    if (linear < 1e-9) {
        return {};
    }
    const double x = linear / (parameters_.shape * peak_n);
    const double curved = x - parameters_.curvature * (x - std::atan(x));
    const double scale = peak_n * std::sin(parameters_.shape * std::atan(curved)) / linear;
    return {scale * linear_longitudinal, scale * linear_lateral};
}

void Tyre::advance(TyreSlip& slip, double forward_mps, double slip_speed_mps, double leftward_mps,
                   double step_s) const {
    const double rate = step_s / parameters_.relaxation_length_m;
    const double speed = std::max(std::abs(forward_mps), smallest_relaxation_speed_mps);
    const double decay = 1.0 / (1.0 + rate * speed);
    slip.longitudinal = (slip.longitudinal + rate * slip_speed_mps) * decay;
    slip.lateral = (slip.lateral - rate * leftward_mps) * decay;
}

}  // namespace sil
