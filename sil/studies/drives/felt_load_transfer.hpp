// Felt load transfer: how much load the forces on a vehicle can have moved to one side, where no wheel loads
// are measured.
#pragma once

#include <vector>

#include "rsi/types.hpp"
#include "sil/judge/warning_judgement.hpp"
#include "sil/studies/drives/drive_replay.hpp"

namespace sil {

inline constexpr double felt_about_s = 1.0;  // before a warning and after it

// 2 (m_s h + m_u h_u) / (m c_w): load transfer ratio per lateral force over vertical force.
double height_share(const rsi::Parameters& parameters);

// The largest |LTR| from felt_about_s before the warning to felt_about_s after it: height_share times lateral
// over vertical acceleration, both in the body's axes, which holds on any bank and needs no roll angle. They
// are means over 0.1 s: the roll's own inertia is left out, and over such a time has little part in it. NaN
// without a lateral acceleration.
double felt_load_transfer(const std::vector<ReplayCycle>& cycles, double height_share,
                          const NamedWarning& warning);

}  // namespace sil
