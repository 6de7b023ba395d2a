// Critical roll angle: where the inner wheels lift in a steady turn.
#pragma once

#include "rsi/types.hpp"

namespace rsi {

// phi_c of (28): where the linear spring moment K_f phi equals m_s H g [T(phi) + tan phi],
// T(phi) = (c_w/2 - H tan phi)/h, so that the inner wheels lift in a steady turn. NaN where there is no such
// angle below 1 rad: the springs are then too soft for it, or the track too wide.
[[gnu::cold]] float critical_roll_angle_rad(const Parameters& parameters);

}  // namespace rsi
