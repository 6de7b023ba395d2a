// Suspension forces: spring, stops and damper of one wheel, and the path of an independent front wheel.
#pragma once

#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Force that pushes wheel and body apart, and the energy that its elastic part has stored.
class SpringDamper {
 public:
    SpringDamper(const SpringDamperParameters& parameters, double preload_n)
        : parameters_{parameters}, preload_n_{preload_n} {}

    double elastic_force_n(double jounce_m) const {
        double force = preload_n_ + parameters_.spring_npm * jounce_m;
        if (jounce_m > parameters_.jounce_clearance_m) {
            const double beyond = jounce_m - parameters_.jounce_clearance_m;
            force += parameters_.jounce_stop_npm2 * beyond * beyond;
        } else if (jounce_m < -parameters_.rebound_clearance_m) {
            const double beyond = jounce_m + parameters_.rebound_clearance_m;
            force -= parameters_.rebound_stop_npm2 * beyond * beyond;
        }
        return force;
    }

    double damper_force_n(double jounce_rate_mps) const {
        return jounce_rate_mps *
               (jounce_rate_mps > 0.0 ? parameters_.damper_bump_nspm : parameters_.damper_rebound_nspm);
    }

    double stored_energy_j(double jounce_m) const;

 private:
    SpringDamperParameters parameters_;
    double preload_n_;
};

// Where the wheel stands sideways at a given jounce, and how it moves there. Outwards is positive. The
// lateral tyre force times the slope is the jacking force (virtual work), so the slope is all there is to a
// roll centre.
class FrontWheelPath {
 public:
    explicit FrontWheelPath(const FrontSuspensionParameters& parameters)
        : slope_0_{parameters.path_slope_0},
          slope_1_{parameters.path_slope_1_pm},
          slope_2_{parameters.path_slope_2_pm2} {}

    double outward_m(double jounce_m) const {
        return jounce_m * (slope_0_ + jounce_m * (-slope_1_ / 2.0 + jounce_m * slope_2_ / 3.0));
    }
    double slope(double jounce_m) const { return slope_0_ + jounce_m * (-slope_1_ + jounce_m * slope_2_); }
    double slope_rate_pm(double jounce_m) const { return -slope_1_ + 2.0 * slope_2_ * jounce_m; }

 private:
    double slope_0_;
    double slope_1_;
    double slope_2_;
};

}  // namespace sil
