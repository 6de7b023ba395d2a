#include "rsi/indicator/extended_indicator.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

constexpr float smallest_half_track_ratio = 0.05F;

}  // namespace

void ExtendedIndicator::init(const Parameters& parameters) {
    const float m_s = parameters.sprung_mass_kg;
    const float m_u = parameters.unsprung_mass_kg;
    half_track_moment_kgm_ = (m_s + m_u) * 0.5F * parameters.track_width_m;
    shift_moment_kgm_ = m_s * (parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m);
    roll_inertia_kgm2_ = parameters.roll_inertia_kgm2;
    height_moment_kgm_ = m_s * parameters.sprung_cg_height_m + m_u * parameters.unsprung_cg_height_m;
}

float ExtendedIndicator::level(float parallel_force_mps2, float normal_inverse, float tan_roll_angle,
                               float roll_acceleration_radps2) const {
    const float s = (parallel_force_mps2 < 0.0F) ? -1.0F : 1.0F;
    const float righting_kgm =
        half_track_moment_kgm_ + s * (roll_inertia_kgm2_ * roll_acceleration_radps2 * normal_inverse -
                                      shift_moment_kgm_ * tan_roll_angle);
    const float bounded_kgm = larger(righting_kgm, smallest_half_track_ratio * height_moment_kgm_);
    return clamp(s * parallel_force_mps2 * normal_inverse * height_moment_kgm_ / bounded_kgm, 0.0F, 20.0F);
}

}  // namespace rsi
