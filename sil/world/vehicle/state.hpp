// State of the vehicle: 14 degrees of freedom, and that of a frame that twists; the slip of each tyre, the
// dry friction of each spring, a load that moves, and a trailer.
#pragma once

#include <array>

#include "sil/world/vehicle/truth.hpp"
#include "sil/world/vehicle/tyre.hpp"
#include "sil/world/vehicle/vector.hpp"

namespace sil {

// A trailer's CG and heading in the earth-fixed frame.
template <typename Real>
struct BasicTrailerState {
    Real x_m{0.0};
    Real y_m{0.0};
    Real yaw_rad{0.0};
    Real x_mps{0.0};
    Real y_mps{0.0};
    Real yaw_rate_radps{0.0};
};

template <typename Real>
struct BasicState {
    Real time_s{0.0};
    Vector3Of<Real> position{Vector3Of<Real>::Zero()};               // sprung CG in the earth-fixed frame
    QuaternionOf<Real> orientation{QuaternionOf<Real>::Identity()};  // body axes to earth-fixed
    Vector3Of<Real> velocity{Vector3Of<Real>::Zero()};               // body components
    Vector3Of<Real> angular_velocity{Vector3Of<Real>::Zero()};       // body components
    std::array<Real, 4> suspension{};  // front left jounce, front right jounce, axle heave, axle roll
    std::array<Real, 4> suspension_rate{};
    Real frame_twist_rad{
        0.0};  // of the rear part of the body against the front part, > 0: leaning more to the right
    Real frame_twist_radps{0.0};
    std::array<Real, wheel_count> friction_share{};    // of the largest dry friction, > 0 against jounce
    std::array<Real, wheel_count> wheel_spin_radps{};  // > 0 when rolling forward
    std::array<BasicTyreSlip<Real>, wheel_count> slip{};
    Real reached_handwheel_rad{0.0};  // the handwheel angle that the road wheels follow
    Real front_lateral_n{0.0};        // of the front tyres together, square to the wheels
    Real load_offset_m{0.0};          // of a load that moves, to the left in the body
    Real load_rate_mps{0.0};
    BasicTrailerState<Real> trailer{};
    // How far each wheel has lately slid sideways through soft ground, > 0 where that pushes it to the left.
    std::array<Real, wheel_count> ploughed_m{};
};
using State = BasicState<double>;

}  // namespace sil
