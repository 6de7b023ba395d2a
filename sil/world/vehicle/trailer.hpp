// Trailer: a body in the plane of the road that hangs on the vehicle's hitch and follows on its own axle. It
// pushes and pulls the vehicle, and does not roll itself.
#pragma once

#include "sil/world/vehicle/equations_of_motion.hpp"
#include "sil/world/vehicle/evaluation.hpp"
#include "sil/world/vehicle/number.hpp"
#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/state.hpp"

namespace sil {

// Behind the vehicle, straight, and as fast.
template <typename Real>
void hitch_trailer(const BasicVehicleParameters<Real>& vehicle, const Matrix3Of<Real>& rotation,
                   const Vector3Of<Real>& velocity_earth, BasicState<Real>& state) {
    const Real behind = vehicle.trailer.hitch_behind_cg_m + vehicle.trailer.drawbar_m;
    state.trailer.x_m = state.position.x() - behind * rotation(0, 0);
    state.trailer.y_m = state.position.y() - behind * rotation(1, 0);
    state.trailer.yaw_rad = number::atan2(rotation(1, 0), rotation(0, 0));
    state.trailer.x_mps = velocity_earth.x();
    state.trailer.y_mps = velocity_earth.y();
    state.trailer.yaw_rate_radps = 0.0;
}

// Advances the trailer by a step and adds the hitch's force to the vehicle. The hitch is a stiff, damped
// spring, the tyres give a force that saturates at their friction.
template <typename Real>
void pull_trailer(const BasicVehicleParameters<Real>& vehicle, const BasicEvaluation<Real>& evaluation,
                  double step_s, BasicState<Real>& state, EquationsOfMotion<Real>& equations) {
    constexpr double hitch_radps = 40.0;  // of the trailer's mass on the hitch
    constexpr double hitch_damping_ratio = 0.7;
    constexpr double slowest_mps = 1.0;     // below it the tyres slip as if at it
    constexpr double stiffness_prad = 8.0;  // of the tyres, over their load
    const BasicTrailerParameters<Real>& trailer = vehicle.trailer;
    const auto pulled = trailer.mass_kg > 0.0;
    if (!number::any(pulled)) {
        return;
    }
    BasicTrailerState<Real>& moves = state.trailer;
    Real sine;
    Real cosine;
    number::sin_and_cos(moves.yaw_rad, sine, cosine);

    const Vector3Of<Real> hitch{-trailer.hitch_behind_cg_m, 0.0,
                                trailer.hitch_height_m - vehicle.geometry.cg_height_m};
    const Vector3Of<Real> place = state.position + product(evaluation.rotation, hitch);
    const Vector3Of<Real> body_velocity = state.velocity + state.angular_velocity.cross(hitch);
    const Vector3Of<Real> velocity = product(evaluation.rotation, body_velocity);
    const Real apart_x = place.x() - (moves.x_m + trailer.drawbar_m * cosine);
    const Real apart_y = place.y() - (moves.y_m + trailer.drawbar_m * sine);
    const Real parting_x = velocity.x() - (moves.x_mps - trailer.drawbar_m * sine * moves.yaw_rate_radps);
    const Real parting_y = velocity.y() - (moves.y_mps + trailer.drawbar_m * cosine * moves.yaw_rate_radps);
    const Real spring = trailer.mass_kg * hitch_radps * hitch_radps;
    const Real damper = trailer.mass_kg * 2.0 * hitch_damping_ratio * hitch_radps;
    const Real pull_x = spring * apart_x + damper * parting_x;
    const Real pull_y = spring * apart_y + damper * parting_y;

    const Real forward = moves.x_mps * cosine + moves.y_mps * sine;
    const Real leftward =
        moves.y_mps * cosine - moves.x_mps * sine - trailer.axle_behind_cg_m * moves.yaw_rate_radps;
    const Real load_n = trailer.mass_kg * gravity_mps2;
    const Real linear = stiffness_prad * load_n * leftward / number::max(number::abs(forward), slowest_mps);
    const Real over_limit = linear / (vehicle.tyre.friction * load_n);
    const Real tyre_n = -linear / number::sqrt(1.0 + over_limit * over_limit);

    const Real turning =
        trailer.drawbar_m * (pull_y * cosine - pull_x * sine) - trailer.axle_behind_cg_m * tyre_n;
    BasicTrailerState<Real> next = moves;
    next.x_mps += step_s * (pull_x - tyre_n * sine) / trailer.mass_kg;
    next.y_mps += step_s * (pull_y + tyre_n * cosine) / trailer.mass_kg;
    next.yaw_rate_radps += step_s * turning / trailer.yaw_inertia_kgm2;
    next.x_m += step_s * next.x_mps;
    next.y_m += step_s * next.y_mps;
    next.yaw_rad += step_s * next.yaw_rate_radps;
    moves.x_m = number::choose(pulled, next.x_m, moves.x_m);
    moves.y_m = number::choose(pulled, next.y_m, moves.y_m);
    moves.yaw_rad = number::choose(pulled, next.yaw_rad, moves.yaw_rad);
    moves.x_mps = number::choose(pulled, next.x_mps, moves.x_mps);
    moves.y_mps = number::choose(pulled, next.y_mps, moves.y_mps);
    moves.yaw_rate_radps = number::choose(pulled, next.yaw_rate_radps, moves.yaw_rate_radps);

    const Vector3Of<Real> force{-pull_x, -pull_y, 0.0};
    equations.add_force_if(pulled, transposed_product(evaluation.rotation, force), hitch);
}

}  // namespace sil
