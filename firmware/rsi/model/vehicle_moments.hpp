// Vehicle moments: what the whole vehicle's inertia and weight turn with, unsprung masses and load included.
#pragma once

namespace rsi {

struct VehicleMoments {
    float height_kgm{0.0F};         // of A: m_s h + m_u h_u
    float shift_kgm{0.0F};          // of N tan phi: m_s (h - h_frc)
    float roll_inertia_kgm2{0.0F};  // of phi'': Ixx
    float half_weight_kgm{1.0F};    // of N, all of it on one side's wheels: (m_s + m_u) c_w / 2
};

}  // namespace rsi
