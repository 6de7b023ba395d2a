// Hull: the bodywork's corners on the road once the vehicle has tipped over, each a stiff, damped, rubbing
// spring; keeps it from falling through.
#pragma once

#include "sil/world/vehicle/equations_of_motion.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/road.hpp"
#include "sil/world/vehicle/state.hpp"

namespace sil {

// Adds the forces of all corners that are below the road, in the vehicles that have `tipped`. `rotation`:
// body axes to earth-fixed.
template <typename Real, typename Ground, typename Condition>
void add_hull_contact(Condition tipped, const BasicHullParameters<Real>& hull, const BasicState<Real>& state,
                      const Matrix3Of<Real>& rotation, const Ground& road,
                      EquationsOfMotion<Real>& equations) {
    constexpr double stiffness_npm = 400.0e3;
    constexpr double damping_nspm = 15.0e3;
    constexpr double friction = 0.4;
    constexpr double sliding_speed_mps = 0.2;  // above it friction is nearly complete
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3Of<Real> point{(corner & 1) != 0 ? hull.half_length_m : -hull.half_length_m,
                                    (corner & 2) != 0 ? hull.half_width_m : -hull.half_width_m,
                                    (corner & 4) != 0 ? hull.top_above_cg_m : -hull.bottom_below_cg_m};
        const Vector3Of<Real> earth_point = state.position + product(rotation, point);
        const BasicRoadPoint<Real> surface = road.at(earth_point.x(), earth_point.y());
        const Real depth = (surface.height_m - earth_point.z()) * surface.normal.z();
        const auto touches = tipped && depth > 0.0;
        if (!number::any(touches)) {
            continue;
        }
        const Vector3Of<Real> body_velocity = state.velocity + state.angular_velocity.cross(point);
        const Vector3Of<Real> velocity = product(rotation, body_velocity);
        const Real sinking = -dot3(velocity, surface.normal);
        const Real load = number::max(0.0, stiffness_npm * depth + damping_nspm * sinking);
        const Vector3Of<Real> sliding = velocity + sinking * surface.normal;
        const Vector3Of<Real> force =
            load * surface.normal - (friction * load / (norm3(sliding) + sliding_speed_mps)) * sliding;
        equations.add_force_if(touches, transposed_product(rotation, force), point);
    }
}

}  // namespace sil
