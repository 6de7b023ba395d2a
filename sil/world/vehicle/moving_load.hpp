// Moving load: liquid that sloshes or cargo that slides, sideways, as one mass on a spring, a damper and dry
// friction between two walls.
#pragma once

#include "sil/world/vehicle/equations_of_motion.hpp"
#include "sil/world/vehicle/evaluation.hpp"
#include "sil/world/vehicle/number.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/state.hpp"

namespace sil {

// Advances the load by a step and adds what its motion does to the body, whose mass contains it: the force
// that accelerates it in the body, and its weight beside the middle. It feels the body's accelerations of the
// step before, as long as these are known; turning of the body adds nothing to its motion but by the height.
template <typename Real>
void move_load(const BasicMovingLoadParameters<Real>& load, const BasicEvaluation<Real>& evaluation,
               double step_s, BasicState<Real>& state, EquationsOfMotion<Real>& equations) {
    constexpr double wall_radps = 60.0;  // frequency at which the load bounces on a wall
    constexpr double wall_damping_ratio = 0.5;
    const auto carried = load.mass_kg > 0.0;
    if (!number::any(carried)) {
        return;
    }
    const BasicAccelerations<Real>& before = evaluation.accelerations;
    const Vector3Of<Real> felt = before.linear + state.angular_velocity.cross(state.velocity) +
                                 gravity_mps2 * evaluation.rotation.row(2).transpose();
    const Real across = felt.y() - before.angular.x() * load.above_cg_m;

    const Real& frequency = load.frequency_radps;
    const Real beyond =
        state.load_offset_m - number::clamp(state.load_offset_m, -load.travel_m, load.travel_m);
    const Real wall = number::choose(
        number::abs(beyond) > 0.0,
        wall_radps * (wall_radps * beyond + 2.0 * wall_damping_ratio * state.load_rate_mps), 0.0);
    const Real back =
        frequency * (frequency * state.load_offset_m + 2.0 * load.damping_ratio * state.load_rate_mps) + wall;
    const Real free_rate = state.load_rate_mps - step_s * (across + back);
    // Dry friction stops the load, and holds it, before it drives it back.
    const Real stopped = step_s * load.friction * number::max(0.0, felt.z());
    const Real rate = free_rate - number::clamp(free_rate, -stopped, stopped);
    const Real acceleration = (rate - state.load_rate_mps) / step_s;
    state.load_rate_mps = number::choose(carried, rate, state.load_rate_mps);
    state.load_offset_m = number::choose(carried, state.load_offset_m + step_s * rate, state.load_offset_m);

    const Vector3Of<Real> place{0.0, state.load_offset_m, load.above_cg_m};
    equations.add_force_if(carried, Vector3Of<Real>{0.0, -load.mass_kg * acceleration, 0.0}, place);
    // The body's mass has the load in the middle; its weight and thrust act where it is.
    const Real moved = load.mass_kg * state.load_offset_m;
    equations.add_moment_if(carried, Vector3Of<Real>{-moved * felt.z(), 0.0, moved * felt.x()});
}

}  // namespace sil
