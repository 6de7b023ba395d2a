// Tyre: vertical spring and Magic Formula forces with relaxation length and friction ellipse.
#pragma once

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Slip that the tyre's deflection has built up: longitudinal kappa, and lateral tan(alpha), positive where
// the force is to the left.
struct TyreSlip {
    double longitudinal{0.0};
    double lateral{0.0};
};

struct TyreForces {
    double longitudinal_n{0.0};  // forward
    double lateral_n{0.0};       // left
};

class Tyre {
 public:
    Tyre(const TyreParameters& parameters, double friction_factor);

    // Never negative: a lifted wheel does not pull. Zero exactly when the tyre does not touch.
    double vertical_force_n(double deflection_m, double deflection_rate_mps) const;

    // `camber`: sine of the angle by which the wheel's top leans to the right.
    TyreForces forces(const TyreSlip& slip, double load_n, double friction_factor, double camber) const;

    // Lets the slip follow the velocities at the contact (rolling minus forward speed, leftward speed).
    void advance(TyreSlip& slip, double forward_mps, double slip_speed_mps, double leftward_mps,
                 double step_s) const;

    double rolling_resistance_n(double load_n) const { return parameters_.rolling_resistance * load_n; }

    double cornering_stiffness_nprad(double load_n) const;
    double friction(double load_n) const;

    double stored_energy_j(double deflection_m) const {
        return 0.5 * parameters_.vertical_stiffness_npm * deflection_m * deflection_m;
    }

 private:
    TyreParameters parameters_;
    double friction_at_no_load_;
    double friction_slope_pn_;
};

}  // namespace sil
