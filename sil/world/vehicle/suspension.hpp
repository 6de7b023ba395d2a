// Suspension forces: spring, stops, dry friction and damper of one wheel, and the path of an independent
// front wheel.
#pragma once

#include "sil/world/vehicle/number.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Force that pushes wheel and body apart, and the energy that its elastic part has stored.
template <typename Real>
class BasicSpringDamper {
 public:
    BasicSpringDamper(const BasicSpringDamperParameters<Real>& parameters, Real preload_n)
        : parameters_{parameters},
          preload_n_{preload_n},
          cubic_npm3_{parameters.spring_npm * parameters.progression_pm2 / 3.0},
          friction_n_{parameters.dry_friction * preload_n} {}

    Real elastic_force_n(Real jounce_m) const {
        const Real spring =
            preload_n_ + parameters_.spring_npm * jounce_m + cubic_npm3_ * jounce_m * jounce_m * jounce_m;
        const Real in_jounce = jounce_m - parameters_.jounce_clearance_m;
        const Real in_rebound = jounce_m + parameters_.rebound_clearance_m;
        return number::choose(
            jounce_m > parameters_.jounce_clearance_m,
            spring + parameters_.jounce_stop_npm2 * in_jounce * in_jounce,
            number::choose(jounce_m < -parameters_.rebound_clearance_m,
                           spring - parameters_.rebound_stop_npm2 * in_rebound * in_rebound, spring));
    }

    Real damper_force_n(Real jounce_rate_mps) const {
        return jounce_rate_mps * number::choose(jounce_rate_mps > 0.0, parameters_.damper_bump_nspm,
                                                parameters_.damper_rebound_nspm);
    }

    // Dry friction after Fancher: as the spring moves on, the force nears the largest one that opposes the
    // motion, with the way that it moves and not with its speed, and so makes a loop. `share` is the present
    // one of that, -1 to 1, > 0 against jounce; `moved_m` is added to the jounce.
    auto has_friction() const { return friction_n_ > 0.0; }
    static Real rubbed_share(Real share, Real moved_m) {
        const Real way = moved_m / rubbing_m;
        return (share + way) / (1.0 + number::abs(way));
    }
    Real friction_force_n(Real share) const { return friction_n_ * share; }
    // Energy that the bent leaves give back.
    Real friction_energy_j(Real share) const { return 0.5 * friction_n_ * rubbing_m * share * share; }

    Real stored_energy_j(Real jounce_m) const {
        const Real square = jounce_m * jounce_m;
        const Real spring = preload_n_ * jounce_m + 0.5 * parameters_.spring_npm * square +
                            0.25 * cubic_npm3_ * square * square;
        const Real in_jounce = jounce_m - parameters_.jounce_clearance_m;
        const Real in_rebound = -jounce_m - parameters_.rebound_clearance_m;
        return number::choose(
            jounce_m > parameters_.jounce_clearance_m,
            spring + parameters_.jounce_stop_npm2 * in_jounce * in_jounce * in_jounce / 3.0,
            number::choose(
                jounce_m < -parameters_.rebound_clearance_m,
                spring + parameters_.rebound_stop_npm2 * in_rebound * in_rebound * in_rebound / 3.0, spring));
    }

 private:
    static constexpr double rubbing_m = 0.003;  // way in which friction changes, of truck springs 2 to 5 mm

    BasicSpringDamperParameters<Real> parameters_;
    Real preload_n_;
    Real cubic_npm3_;
    Real friction_n_;  // the largest
};

// Lateral position and motion of the wheel at a given jounce. Outwards is positive. The
// lateral tyre force times the slope is the jacking force (virtual work), so the slope is all there is to a
// roll centre.
template <typename Real>
class BasicFrontWheelPath {
 public:
    explicit BasicFrontWheelPath(const BasicFrontSuspensionParameters<Real>& parameters)
        : slope_0_{parameters.path_slope_0},
          slope_1_{parameters.path_slope_1_pm},
          slope_2_{parameters.path_slope_2_pm2} {}

    Real outward_m(Real jounce_m) const {
        return jounce_m * (slope_0_ + jounce_m * (-slope_1_ / 2.0 + jounce_m * slope_2_ / 3.0));
    }
    Real slope(Real jounce_m) const { return slope_0_ + jounce_m * (-slope_1_ + jounce_m * slope_2_); }
    Real slope_rate_pm(Real jounce_m) const { return -slope_1_ + 2.0 * slope_2_ * jounce_m; }

 private:
    Real slope_0_;
    Real slope_1_;
    Real slope_2_;
};

}  // namespace sil
