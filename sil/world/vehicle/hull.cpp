// Hull contact: a stiff, damped, rubbing spring at every corner of the bodywork.
#include "sil/world/vehicle/hull.hpp"

#include <algorithm>

namespace sil {
namespace {

constexpr double stiffness_npm = 400.0e3;
constexpr double damping_nspm = 15.0e3;
constexpr double friction = 0.4;
constexpr double sliding_speed_mps = 0.2;  // above it friction is nearly complete

}  // namespace

void add_hull_contact(const HullParameters& hull, const State& state, const Matrix3& rotation,
                      const Road& road, EquationsOfMotion& equations) {
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3 point{(corner & 1) != 0 ? hull.half_length_m : -hull.half_length_m,
                            (corner & 2) != 0 ? hull.half_width_m : -hull.half_width_m,
                            (corner & 4) != 0 ? hull.top_above_cg_m : -hull.bottom_below_cg_m};
        const Vector3 earth_point = state.position + rotation * point;
        const RoadPoint surface = road.at(earth_point.x(), earth_point.y());
        const double depth = (surface.height_m - earth_point.z()) * surface.normal.z();
        if (depth <= 0.0) {
            continue;
        }
        const Vector3 velocity = rotation * (state.velocity + state.angular_velocity.cross(point));
        const double sinking = -velocity.dot(surface.normal);
        const double load = std::max(0.0, stiffness_npm * depth + damping_nspm * sinking);
        const Vector3 sliding = velocity + sinking * surface.normal;
        const Vector3 force =
            load * surface.normal - (friction * load / (sliding.norm() + sliding_speed_mps)) * sliding;
        equations.add_force(rotation.transpose() * force, point);
    }
}

}  // namespace sil
