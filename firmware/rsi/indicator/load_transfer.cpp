#include "rsi/indicator/load_transfer.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {

void LoadTransfer::init(const Parameters& parameters) {
    const float m_s = parameters.sprung_mass_kg;
    const float m_u = parameters.unsprung_mass_kg;
    curve_.init(parameters);
    force_arm_kgm_ = m_s * parameters.fixed_roll_centre_height_m + m_u * parameters.unsprung_cg_height_m;
    roll_damping_nmsprad_ = parameters.roll_damping_nmsprad;
    half_weight_arm_kgm_ = 0.5F * (m_s + m_u) * parameters.track_width_m;
}

float LoadTransfer::ratio(float moment_nm, float normal_inverse) const {
    return clamp(moment_nm * normal_inverse / half_weight_arm_kgm_, -20.0F, 20.0F);
}

}  // namespace rsi
