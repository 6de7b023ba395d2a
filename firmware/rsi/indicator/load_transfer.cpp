#include "rsi/indicator/load_transfer.hpp"

namespace rsi {

void LoadTransfer::init(const Parameters& parameters) {
    const float m_s = parameters.sprung_mass_kg;
    const float m_u = parameters.unsprung_mass_kg;
    curve_.init(parameters);
    inertial_weight_ = parameters.load_transfer_inertial_weight;
    height_moment_kgm_ = m_s * parameters.sprung_cg_height_m + m_u * parameters.unsprung_cg_height_m;
    shift_moment_kgm_ = m_s * (parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m);
    roll_inertia_kgm2_ = parameters.roll_inertia_kgm2;
    force_arm_kgm_ = m_s * parameters.fixed_roll_centre_height_m + m_u * parameters.unsprung_cg_height_m;
    roll_damping_nmsprad_ = parameters.roll_damping_nmsprad;
    half_weight_arm_inverse_ = 1.0F / (0.5F * (m_s + m_u) * parameters.track_width_m);
}

float LoadTransfer::present_moment_nm(const RollMotion& motion, float suspension_moment_nm) const {
    const float A = motion.road_parallel_force_mps2;
    const float suspension = force_arm_kgm_ * A + suspension_moment_nm;
    const float inertial =
        height_moment_kgm_ * A +
        shift_moment_kgm_ * (motion.road_normal_force_mps2 * short_tangent(motion.roll_angle_rad)) -
        roll_inertia_kgm2_ * motion.roll_acceleration_radps2;
    return suspension + inertial_weight_ * (inertial - suspension);
}

float LoadTransfer::ratio(float moment_nm, float normal_inverse) const {
    return moment_nm * (normal_inverse * half_weight_arm_inverse_);
}

}  // namespace rsi
