// Roadside: forces of a kerb's face and of soft ground on a wheel that slides into them, which trip a
// vehicle.
#pragma once

#include "sil/world/vehicle/number.hpp"
#include "sil/world/vehicle/road.hpp"

namespace sil {

// A kerb that holds, against a wheel and links that do not break: stiff as two tyres, damped, pushing only. A
// wheel above the kerb's top passes over it.
template <typename Real>
Real kerb_force_n(const BasicRoadPoint<Real>& surface, Real tyre_deflection_m, Real leftward_mps,
                  Real tyre_stiffness_npm) {
    constexpr double stiffness = 2.0;   // over that of a tyre
    constexpr double damping_s = 0.01;  // over that stiffness
    const Real depth = number::abs(surface.beyond_kerb_m);
    const Real side = number::choose(surface.beyond_kerb_m > 0.0, Real{1.0}, Real{-1.0});
    const Real height = number::max(surface.kerb_height_m, 1e-3);
    // As much of the face as the wheel stands against.
    const Real share = number::clamp((tyre_deflection_m + height) / height, 0.0, 1.0);
    const Real push = stiffness * tyre_stiffness_npm * share * (depth + damping_s * side * leftward_mps);
    return number::choose(depth > 0.0, -side * number::max(0.0, push), 0.0);
}

// The pile beside the wheel grows with the way that the wheel slides sideways, and is left behind as it rolls
// on. `ploughed_m`: State::ploughed_m of this wheel, advanced where the ground is `soft`.
template <typename Real, typename Condition>
Real soft_ground_force_n(Real softness, Real load_n, Real leftward_mps, Real forward_mps, double step_s,
                         Condition soft, Real& ploughed_m) {
    constexpr double whole_pile_m = 0.8;    // of sliding, to the largest force
    constexpr double fresh_ground_m = 1.0;  // of rolling, to be free of most of it
    const Real grown =
        (ploughed_m - step_s * leftward_mps) / (1.0 + step_s / fresh_ground_m * number::abs(forward_mps));
    ploughed_m = number::choose(soft, number::choose(load_n > 0.0, grown, 0.0), ploughed_m);
    return softness * load_n * number::clamp(ploughed_m / whole_pile_m, -1.0, 1.0);
}

}  // namespace sil
