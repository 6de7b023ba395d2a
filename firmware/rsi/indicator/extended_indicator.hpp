// Extended indicator: |A/N| over the half-track ratio with unsprung mass and roll inertia.
#pragma once

#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/sprung_body.hpp"
#include "rsi/types.hpp"

namespace rsi {

// RSI_ext = |A/N| / T_dyn,
// T_dyn = [m_s (c_w/2 - D) + m_u c_w/2 + s Ixx phi''/N] / (m_s h + m_u h_u),  D = s (h - h_frc) tan phi,
// s the sign of A. D is how far the CG really moves: the measured angle about the nominal roll centre.
// Neither (6), with which the angle would be that of the model without inertia, nor dh, which moves T_dyn by
// less than one part in a hundred, enters.
class ExtendedIndicator {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // The body from now on.
    void assume_body(const SprungBody& body);

    // 0 to 20; T_dyn is taken to be at least 0.001 + 0.05 |A/N|.
    float level(const RollMotion& motion) const;

    // The same for a motion that obeys the roll equation, in which phi'' and the angle follow from the moment
    // that the wheels hold against (TransferredLoad::moment_nm): T_dyn is then
    // |A/N| + [(m_s + m_u) c_w/2 - s moment/N] / (m_s h + m_u h_u), so the level is 1 where the load transfer
    // is.
    float level_under_load(float parallel_force_mps2, float normal_force_mps2, float moment_nm) const;

 private:
    float level_of(float force_moment_nm, float righting_nm, float normal_force_mps2) const;

    float half_track_moment_kgm_{1.0F};  // (m_s + m_u) c_w / 2
    float shift_moment_kgm_{0.0F};       // m_s (h - h_frc)
    float roll_inertia_kgm2_{0.0F};
    float height_moment_kgm_{1.0F};   // m_s h + m_u h_u
    float least_moment_kgm_{0.001F};  // of it, at the least T_dyn
    // What a load leaves.
    float half_track_m_{1.0F};
    float unsprung_mass_kg_{0.0F};
    float unsprung_moment_kgm_{0.0F};  // m_u h_u
};

}  // namespace rsi
