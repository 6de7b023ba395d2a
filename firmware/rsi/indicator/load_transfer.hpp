// Load transfer from the roll state: (26) without wheel loads.
#pragma once

#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/vehicle.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Moment between the wheels of the two sides.
struct TransferredLoad {
    float suspension_moment_nm{0.0F};  // M(phi) + c_f phi'
    float moment_nm{0.0F};             // the weighted mean of both forms below
    float ratio{0.0F};                 // LTR, -20 to 20
};

// LTR = 2 / (m N c_w) moment,  m = m_s + m_u, > 0 in a left turn. The moment that the wheels hold against is
// both
//   alpha A + M(phi) + c_f phi',  alpha = m_s h_frc + m_u h_u:
//       what the links, the springs and the dampers carry from one side to the other, and
//   (m_s h + m_u h_u) A + m_s (h - h_frc) N tan phi - Ixx phi'':
//       what the forces on the vehicle leave after the body's roll acceleration.
// The first is as good as K, the second as good as h; the weighted mean of both errs less than either.
//
// At present. `inertial_weight`: that of the second.
TransferredLoad transferred_load(const Vehicle& vehicle, float inertial_weight, const RollMotion& motion);

// LTR for such a moment, -20 to 20.
float load_transfer_ratio(const LoadedBody& loaded, float moment_nm, float normal_force_mps2);

}  // namespace rsi
