#include "rsi/model/vehicle.hpp"

namespace rsi {

Suspension::Suspension(const Parameters& parameters)
    : springs(parameters),
      stiffness_nmprad(parameters.roll_stiffness_nmprad),
      damping_nmsprad(parameters.roll_damping_nmsprad),
      damping_inverse(1.0F / damping_nmsprad),
      angle_to_rate_per_s(stiffness_nmprad * damping_inverse),
      spring_step_s(sample_time_s / (1.0F + 0.5F * sample_time_s * angle_to_rate_per_s)),
      roll_centre_height_m(parameters.fixed_roll_centre_height_m),
      half_track_m(0.5F * parameters.track_width_m),
      unsprung_mass_kg(parameters.unsprung_mass_kg),
      unsprung_moment_kgm(parameters.unsprung_mass_kg * parameters.unsprung_cg_height_m) {}

LoadedBody loaded_body(const Suspension& suspension, const SprungBody& body) {
    LoadedBody loaded;
    loaded.body = body;
    loaded.cg_height_inverse = 1.0F / body.cg_height_m;  // every body's CG is above the road
    loaded.moment_arm_kgm = body.moment_arm_kgm();
    loaded.height_moment_kgm = body.mass_kg * body.cg_height_m + suspension.unsprung_moment_kgm;
    loaded.half_weight_kgm = (body.mass_kg + suspension.unsprung_mass_kg) * suspension.half_track_m;
    loaded.force_arm_kgm = body.mass_kg * suspension.roll_centre_height_m + suspension.unsprung_moment_kgm;
    loaded.force_to_rate = loaded.moment_arm_kgm * suspension.damping_inverse;
    // Positive: K_f >= 1.2 m_s g H is validated, and no load is assumed that K_f does not hold.
    const float gravity_per_s = loaded.force_to_rate * gravity_mps2;
    loaded.upright_step_s =
        sample_time_s / (1.0F + 0.5F * sample_time_s * (suspension.angle_to_rate_per_s - gravity_per_s));
    return loaded;
}

}  // namespace rsi
