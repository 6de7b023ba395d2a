#include "rsi/indicator/extended_indicator.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

constexpr float smallest_dynamic_ratio = 0.001F;

// All of it times N (m_s h + m_u h_u), so that there is one division. The guard keeps the level below 20.
float level_of(float force_moment_nm, float righting_nm, float normal_force_mps2, const LoadedBody& loaded) {
    const float least_nm = smallest_dynamic_ratio * loaded.height_moment_kgm * normal_force_mps2;
    return force_moment_nm / larger(righting_nm, 0.05F * force_moment_nm + least_nm);
}

}  // namespace

float extended_level(const RollMotion& motion, const LoadedBody& loaded) {
    const float A = motion.road_parallel_force_mps2;
    const float N = motion.road_normal_force_mps2;
    const float to_the_left_nm = loaded.body.roll_inertia_kgm2 * motion.roll_acceleration_radps2 -
                                 loaded.moment_arm_kgm * (N * short_tangent(motion.roll_angle_rad));
    const float inward_nm = (A < 0.0F) ? -to_the_left_nm : to_the_left_nm;
    return level_of(absolute(A) * loaded.height_moment_kgm, loaded.half_weight_kgm * N + inward_nm, N,
                    loaded);
}

float extended_level_under_load(float parallel_force_mps2, float normal_force_mps2, float moment_nm,
                                const LoadedBody& loaded) {
    const float force_moment_nm = absolute(parallel_force_mps2) * loaded.height_moment_kgm;
    const float held_nm = (parallel_force_mps2 < 0.0F) ? -moment_nm : moment_nm;
    return level_of(force_moment_nm, loaded.half_weight_kgm * normal_force_mps2 + (force_moment_nm - held_nm),
                    normal_force_mps2, loaded);
}

}  // namespace rsi
