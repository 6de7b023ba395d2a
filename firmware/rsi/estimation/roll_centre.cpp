#include "rsi/estimation/roll_centre.hpp"

namespace rsi {

float lateral_roll_centre_m(const Vehicle& vehicle, const Measurement& measured, const FixedModelRoll& fixed,
                            float vertical_movement_m) {
    const float H = vehicle.loaded.body.roll_arm_m;
    return H * fixed.tan_angle() - (H - vertical_movement_m) * measured.tan_roll_angle;
}

float additional_roll_moment_nm(const Vehicle& vehicle, const Measurement& measured,
                                const RollCentreEstimate& estimate, float lateral_roll_centre_m) {
    const float m_s = vehicle.loaded.body.mass_kg;
    return -(m_s * measured.road_parallel_force_mps2 * estimate.vertical_movement_m +
             m_s * measured.road_normal_force_mps2 * lateral_roll_centre_m +
             estimate.stiffness_deviation_nmprad * measured.roll_angle_rad +
             estimate.damping_deviation_nmsprad * measured.roll_rate_radps) +
           estimate.inertia_moment_nm;
}

}  // namespace rsi
