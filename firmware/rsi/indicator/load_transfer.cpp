#include "rsi/indicator/load_transfer.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

constexpr float largest_ratio = 20.0F;
// Moment of the springs alone, without the links: more than any load transfer that ends in wheel lift.
constexpr float over_ratio = 1.5F;

}  // namespace

TransferredLoad transferred_load(const Vehicle& vehicle, float inertial_weight, const RollMotion& motion) {
    const LoadedBody& loaded = vehicle.loaded;
    const float A = motion.road_parallel_force_mps2;
    const float N = motion.road_normal_force_mps2;
    const float suspension_nm = vehicle.suspension_moment_nm(motion.roll_angle_rad, motion.roll_rate_radps);
    const float by_suspension_nm = loaded.force_arm_kgm * A + suspension_nm;
    const float by_forces_nm = loaded.height_moment_kgm * A +
                               loaded.moment_arm_kgm * (N * short_tangent(motion.roll_angle_rad)) -
                               loaded.body.roll_inertia_kgm2 * motion.roll_acceleration_radps2;
    const float moment_nm = by_suspension_nm + inertial_weight * (by_forces_nm - by_suspension_nm);
    // If even springs without bump stops would hold more than the weight, the wheels of the other side are
    // up, and a suspension that has left the road says nothing.
    const float by_springs =
        load_transfer_ratio(loaded, vehicle.suspension.stiffness_nmprad * motion.roll_angle_rad, N);
    const bool is_over = !is_within_magnitude(by_springs, over_ratio);
    return TransferredLoad{suspension_nm, moment_nm,
                           is_over ? by_springs : load_transfer_ratio(loaded, moment_nm, N)};
}

float load_transfer_ratio(const LoadedBody& loaded, float moment_nm, float normal_force_mps2) {
    return clamp_magnitude(moment_nm / (normal_force_mps2 * loaded.half_weight_kgm), largest_ratio);
}

}  // namespace rsi
