// Disturbance: what acts on the vehicle from outside at one instant, beside the road and the driver.
#pragma once

#include <array>

#include "sil/world/vehicle/truth.hpp"

namespace sil {

// The default is nothing, and changes no bit of a run.
template <typename Real>
struct BasicDisturbance {
    // Force of the wind on the body, to its left, and its place in body axes from the sprung CG.
    Real side_force_n{0.0};
    Real side_force_ahead_m{0.0};
    Real side_force_above_m{0.0};
    std::array<Real, wheel_count> grip{1.0, 1.0, 1.0, 1.0};  // multiplies the friction under a wheel, above 0
    std::array<Real, wheel_count> lost_air{};                // of a tyre, 0 (none) to 1 (flat)
};
using Disturbance = BasicDisturbance<double>;

// A tyre without air: it stands on its side walls, gives way sideways and drags. Shares of a usual passenger
// car tyre (aspect ratio 0.55) whose bead stays on the rim; what a rim does that digs into the road is not in
// them.
struct FlatTyre {
    static constexpr double lost_radius = 0.2;        // of the unloaded radius
    static constexpr double lost_stiffness = 0.7;     // of the cornering and longitudinal stiffness
    static constexpr double lost_friction = 0.3;      // of the friction
    static constexpr double added_resistance = 10.0;  // times the rolling resistance
};

}  // namespace sil
