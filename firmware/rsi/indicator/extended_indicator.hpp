// Extended indicator: |A/N| over the half-track ratio with unsprung mass and roll inertia.
#pragma once

#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/vehicle.hpp"

namespace rsi {

// RSI_ext = |A/N| / T_dyn,
// T_dyn = [m_s (c_w/2 - D) + m_u c_w/2 + s Ixx phi''/N] / (m_s h + m_u h_u),  D = s (h - h_frc) tan phi,
// s the sign of A. D is how far the CG really moves: the measured angle about the nominal roll centre.
// Neither (6), with which the angle would be that of the model without inertia, nor dh, which moves T_dyn by
// less than one part in a hundred, enters.
//
// 0 to 20; T_dyn is taken to be at least 0.001 + 0.05 |A/N|.
float extended_level(const RollMotion& motion, const LoadedBody& loaded);

// The same for a motion that obeys the roll equation, in which phi'' and the angle follow from the moment
// that the wheels hold against (TransferredLoad::moment_nm). The level is 1 where the load transfer is:
// T_dyn = |A/N| + [(m_s + m_u) c_w/2 - s moment/N] / (m_s h + m_u h_u).
float extended_level_under_load(float parallel_force_mps2, float normal_force_mps2, float moment_nm,
                                const LoadedBody& loaded);

}  // namespace rsi
