#include "rsi/estimation/regression.hpp"

namespace rsi {

Regression regress(const Vehicle& vehicle, const Measurement& measured, const FixedModelRoll& fixed) {
    const float m_s = vehicle.loaded.body.mass_kg;
    const float A_force = m_s * measured.road_parallel_force_mps2;
    const float N_force = m_s * measured.road_normal_force_mps2;

    Regression regression;
    regression.output_nm =
        vehicle.suspension.damping_nmsprad * (fixed.rate_radps() - measured.roll_rate_radps) +
        (vehicle.suspension.stiffness_nmprad - N_force * vehicle.loaded.body.roll_arm_m) *
            (fixed.angle_rad() - measured.roll_angle_rad);
    regression.psi << A_force + N_force * measured.tan_roll_angle, measured.roll_angle_rad,
        measured.roll_rate_radps;
    return regression;
}

}  // namespace rsi
