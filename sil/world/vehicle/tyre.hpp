// Tyre: vertical spring and Magic Formula forces with relaxation length and friction ellipse; the Magic
// Formula after Pacejka, both slips combined on one ellipse.
#pragma once

#include "sil/world/vehicle/number.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Slip that the tyre's deflection has built up: longitudinal kappa, and lateral tan(alpha), positive where
// the force is to the left.
template <typename Real>
struct BasicTyreSlip {
    Real longitudinal{0.0};
    Real lateral{0.0};
};
using TyreSlip = BasicTyreSlip<double>;

template <typename Real>
struct BasicTyreForces {
    Real longitudinal_n{0.0};  // forward
    Real lateral_n{0.0};       // left
};
using TyreForces = BasicTyreForces<double>;

template <typename Real>
class BasicTyre {
 public:
    BasicTyre(const BasicTyreParameters<Real>& parameters, Real friction_factor)
        : parameters_{parameters},
          friction_at_no_load_{parameters.friction * friction_factor *
                               (1.0 + parameters.friction_load_sensitivity)},
          friction_slope_pn_{-parameters.friction * friction_factor * parameters.friction_load_sensitivity /
                             reference_load_n} {}

    // Never negative: a lifted wheel does not pull. Zero exactly when the tyre does not touch.
    Real vertical_force_n(Real deflection_m, Real deflection_rate_mps) const {
        return number::choose(deflection_m <= 0.0, 0.0,
                              number::max(0.0, parameters_.vertical_stiffness_npm * deflection_m +
                                                   parameters_.vertical_damping_nspm * deflection_rate_mps));
    }

    // `camber`: sine of the angle by which the wheel's top leans to the right. `stiffness_factor`: of both
    // slips, 1 for a tyre with its air.
    BasicTyreForces<Real> forces(const BasicTyreSlip<Real>& slip, Real load_n, Real friction_factor,
                                 Real camber, Real stiffness_factor = 1.0) const {
        const Real peak_n = friction(load_n) * friction_factor * load_n;
        const Real stiffness = cornering_stiffness_nprad(load_n) * stiffness_factor;
        const Real linear_lateral =
            stiffness * slip.lateral - parameters_.camber_thrust_prad * load_n * camber;
        const Real linear_longitudinal = parameters_.slip_stiffness_ratio * stiffness * slip.longitudinal;
        const Real linear =
            number::sqrt(linear_lateral * linear_lateral + linear_longitudinal * linear_longitudinal);
        const auto gives_none = load_n <= 0.0 || peak_n <= 0.0 || linear < 1e-9;
        if (number::all(gives_none)) {
            return {};
        }
        const Real x = linear / (parameters_.shape * peak_n);
        const Real curved = x - parameters_.curvature * (x - number::atan(x));
        const Real scale = peak_n * number::sin(parameters_.shape * number::atan(curved)) / linear;
        return {number::choose(gives_none, 0.0, scale * linear_longitudinal),
                number::choose(gives_none, 0.0, scale * linear_lateral)};
    }

    // Lets the slip follow the velocities at the contact (rolling minus forward speed, leftward speed).
    void advance(BasicTyreSlip<Real>& slip, Real forward_mps, Real slip_speed_mps, Real leftward_mps,
                 double step_s) const {
        const Real rate = step_s / parameters_.relaxation_length_m;
        const Real speed = number::max(number::abs(forward_mps), smallest_relaxation_speed_mps);
        const Real decay = 1.0 / (1.0 + rate * speed);
        slip.longitudinal = (slip.longitudinal + rate * slip_speed_mps) * decay;
        slip.lateral = (slip.lateral - rate * leftward_mps) * decay;
    }

    // How far to the left of where the rim would have it the contact patch lies.
    Real lateral_deflection_m(Real lateral_n) const { return parameters_.lateral_compliance_mpn * lateral_n; }

    Real rolling_resistance_n(Real load_n) const { return parameters_.rolling_resistance * load_n; }

    Real cornering_stiffness_nprad(Real load_n) const {
        // sin(2 atan(x)) = 2 x / (1 + x^2)
        const Real relative_load = load_n / parameters_.cornering_stiffness_load_n;
        return parameters_.cornering_stiffness_nprad * 2.0 * relative_load /
               (1.0 + relative_load * relative_load);
    }
    Real friction(Real load_n) const {
        return number::max(smallest_friction, friction_at_no_load_ + friction_slope_pn_ * load_n);
    }

    Real stored_energy_j(Real deflection_m) const {
        return 0.5 * parameters_.vertical_stiffness_npm * deflection_m * deflection_m;
    }

 private:
    static constexpr double reference_load_n = 6000.0;
    static constexpr double smallest_friction = 0.05;
    // Below this speed relaxation goes on as if at it, so that a standing vehicle comes to rest.
    static constexpr double smallest_relaxation_speed_mps = 0.5;

    BasicTyreParameters<Real> parameters_;
    Real friction_at_no_load_;
    Real friction_slope_pn_;
};
using Tyre = BasicTyre<double>;

}  // namespace sil
