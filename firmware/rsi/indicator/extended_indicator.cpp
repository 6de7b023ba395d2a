#include "rsi/indicator/extended_indicator.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

constexpr float smallest_dynamic_ratio = 0.001F;

}  // namespace

void ExtendedIndicator::init(const Parameters& parameters) {
    half_track_m_ = 0.5F * parameters.track_width_m;
    unsprung_mass_kg_ = parameters.unsprung_mass_kg;
    unsprung_moment_kgm_ = parameters.unsprung_mass_kg * parameters.unsprung_cg_height_m;
    assume_body(calibrated_body(parameters));
}

void ExtendedIndicator::assume_body(const SprungBody& body) {
    half_track_moment_kgm_ = (body.mass_kg + unsprung_mass_kg_) * half_track_m_;
    shift_moment_kgm_ = body.moment_arm_kgm();
    roll_inertia_kgm2_ = body.roll_inertia_kgm2;
    height_moment_kgm_ = body.mass_kg * body.cg_height_m + unsprung_moment_kgm_;
    least_moment_kgm_ = smallest_dynamic_ratio * height_moment_kgm_;
}

// All of it times N (m_s h + m_u h_u), so that there is one division. The guard keeps the level below 20.
float ExtendedIndicator::level_of(float force_moment_nm, float righting_nm, float normal_force_mps2) const {
    return force_moment_nm /
           larger(righting_nm, 0.05F * force_moment_nm + least_moment_kgm_ * normal_force_mps2);
}

float ExtendedIndicator::level(const RollMotion& motion) const {
    const float A = motion.road_parallel_force_mps2;
    const float N = motion.road_normal_force_mps2;
    const float to_the_left_nm = roll_inertia_kgm2_ * motion.roll_acceleration_radps2 -
                                 shift_moment_kgm_ * (N * short_tangent(motion.roll_angle_rad));
    const float inward_nm = (A < 0.0F) ? -to_the_left_nm : to_the_left_nm;
    return level_of(absolute(A) * height_moment_kgm_, half_track_moment_kgm_ * N + inward_nm, N);
}

float ExtendedIndicator::level_under_load(float parallel_force_mps2, float normal_force_mps2,
                                          float moment_nm) const {
    const float force_moment_nm = absolute(parallel_force_mps2) * height_moment_kgm_;
    const float held_nm = (parallel_force_mps2 < 0.0F) ? -moment_nm : moment_nm;
    return level_of(force_moment_nm, half_track_moment_kgm_ * normal_force_mps2 + (force_moment_nm - held_nm),
                    normal_force_mps2);
}

}  // namespace rsi
