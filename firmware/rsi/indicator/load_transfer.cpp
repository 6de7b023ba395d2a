#include "rsi/indicator/load_transfer.hpp"

#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

constexpr float largest_ratio = 20.0F;
// Of the springs alone, without what the links carry: more than any load transfer that ends in wheel lift.
constexpr float over_ratio = 1.5F;

}  // namespace

void LoadTransfer::init(const Parameters& parameters) {
    curve_.init(parameters);
    inertial_weight_ = parameters.load_transfer_inertial_weight;
    roll_stiffness_nmprad_ = parameters.roll_stiffness_nmprad;
    roll_damping_nmsprad_ = parameters.roll_damping_nmsprad;
    roll_centre_height_m_ = parameters.fixed_roll_centre_height_m;
    half_track_m_ = 0.5F * parameters.track_width_m;
    unsprung_mass_kg_ = parameters.unsprung_mass_kg;
    unsprung_moment_kgm_ = parameters.unsprung_mass_kg * parameters.unsprung_cg_height_m;
    assume_body(calibrated_body(parameters));
}

void LoadTransfer::assume_body(const SprungBody& body) {
    vehicle_ = VehicleMoments{body.mass_kg * body.cg_height_m + unsprung_moment_kgm_, body.moment_arm_kgm(),
                              body.roll_inertia_kgm2, (body.mass_kg + unsprung_mass_kg_) * half_track_m_};
    force_arm_kgm_ = body.mass_kg * roll_centre_height_m_ + unsprung_moment_kgm_;
}

TransferredLoad LoadTransfer::evaluate(const RollMotion& motion) const {
    const float A = motion.road_parallel_force_mps2;
    const float N = motion.road_normal_force_mps2;
    const float suspension_nm = suspension_moment_nm(motion.roll_angle_rad, motion.roll_rate_radps);
    const float by_suspension_nm = force_arm_kgm_ * A + suspension_nm;
    const float by_forces_nm = vehicle_.height_kgm * A +
                               vehicle_.shift_kgm * (N * short_tangent(motion.roll_angle_rad)) -
                               vehicle_.roll_inertia_kgm2 * motion.roll_acceleration_radps2;
    const float moment_nm = by_suspension_nm + inertial_weight_ * (by_forces_nm - by_suspension_nm);
    // Where even springs without bump stops would hold more than the weight, the wheels of the other side are
    // up, and a suspension that has left the road says nothing.
    const float by_springs = ratio(roll_stiffness_nmprad_ * motion.roll_angle_rad, N);
    const bool is_over = !is_within_magnitude(by_springs, over_ratio);
    return TransferredLoad{suspension_nm, moment_nm, is_over ? by_springs : ratio(moment_nm, N)};
}

float LoadTransfer::ratio(float moment_nm, float normal_force_mps2) const {
    return clamp_magnitude(moment_nm / (normal_force_mps2 * vehicle_.half_weight_kgm), largest_ratio);
}

}  // namespace rsi
