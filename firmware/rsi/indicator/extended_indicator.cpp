#include "rsi/indicator/extended_indicator.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

constexpr float smallest_dynamic_ratio = 0.05F;

}  // namespace

void ExtendedIndicator::init(const Parameters& parameters) {
    const float m_s = parameters.sprung_mass_kg;
    const float m_u = parameters.unsprung_mass_kg;
    half_track_moment_kgm_ = (m_s + m_u) * 0.5F * parameters.track_width_m;
    shift_moment_kgm_ = m_s * (parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m);
    roll_inertia_kgm2_ = parameters.roll_inertia_kgm2;
    height_moment_kgm_ = m_s * parameters.sprung_cg_height_m + m_u * parameters.unsprung_cg_height_m;
}

// All of it times N (m_s h + m_u h_u), so that there is one division.
float ExtendedIndicator::level_of(float force_moment_nm, float righting_nm, float normal_force_mps2) const {
    const float least_nm = smallest_dynamic_ratio * height_moment_kgm_ * normal_force_mps2;
    return clamp(force_moment_nm / larger(righting_nm, least_nm), 0.0F, 20.0F);
}

float ExtendedIndicator::level(float parallel_force_mps2, float normal_force_mps2, float tan_roll_angle,
                               float roll_acceleration_radps2) const {
    const float s = (parallel_force_mps2 < 0.0F) ? -1.0F : 1.0F;
    const float righting_nm = half_track_moment_kgm_ * normal_force_mps2 +
                              s * (roll_inertia_kgm2_ * roll_acceleration_radps2 -
                                   shift_moment_kgm_ * normal_force_mps2 * tan_roll_angle);
    return level_of(s * parallel_force_mps2 * height_moment_kgm_, righting_nm, normal_force_mps2);
}

float ExtendedIndicator::level_under_load(float parallel_force_mps2, float normal_force_mps2,
                                          float moment_nm) const {
    const float s = (parallel_force_mps2 < 0.0F) ? -1.0F : 1.0F;
    const float force_moment_nm = s * parallel_force_mps2 * height_moment_kgm_;
    const float righting_nm = half_track_moment_kgm_ * normal_force_mps2 + force_moment_nm - s * moment_nm;
    return level_of(force_moment_nm, righting_nm, normal_force_mps2);
}

}  // namespace rsi
