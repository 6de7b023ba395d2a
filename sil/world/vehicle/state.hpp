// State of the vehicle: 14 degrees of freedom and the slip of each tyre.
#pragma once

#include <array>

#include "sil/world/vehicle/truth.hpp"
#include "sil/world/vehicle/tyre.hpp"
#include "sil/world/vehicle/vector.hpp"

namespace sil {

struct State {
    double time_s{0.0};
    Vector3 position{Vector3::Zero()};                               // sprung CG in the earth-fixed frame
    Eigen::Quaterniond orientation{Eigen::Quaterniond::Identity()};  // body axes to earth-fixed
    Vector3 velocity{Vector3::Zero()};                               // body components
    Vector3 angular_velocity{Vector3::Zero()};                       // body components
    std::array<double, 4> suspension{};  // front left jounce, front right jounce, axle heave, axle roll
    std::array<double, 4> suspension_rate{};
    std::array<double, wheel_count> wheel_spin_radps{};  // > 0 when rolling forward
    std::array<TyreSlip, wheel_count> slip{};
    double reached_handwheel_rad{0.0};  // the handwheel angle that the road wheels follow
};

}  // namespace sil
