#include "rsi/comparison/energy_margin.hpp"

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"
#include "rsi/numeric/square.hpp"

namespace rsi {

EnergyMargin::EnergyMargin(const Parameters& parameters, float critical_roll_angle_rad)
    : critical_roll_angle_rad_(critical_roll_angle_rad) {
    const float H = roll_arm_m(parameters);
    const float K_f = parameters.roll_stiffness_nmprad;
    const float m_s = parameters.sprung_mass_kg;
    const float phi_c = critical_roll_angle_rad_;
    const float versine_c = bounded_sine_and_versine(phi_c).versine;
    // K_f >= 1.2 m_s g H is validated, so this energy is positive.
    const float E_crit_inverse = 1.0F / (0.5F * K_f * phi_c * phi_c - m_s * gravity_mps2 * H * versine_c);
    stiffness_share_ = 0.5F * K_f * E_crit_inverse;
    gravity_share_ = m_s * gravity_mps2 * H * E_crit_inverse;
    inertia_share_ = 0.5F * (parameters.roll_inertia_kgm2 + m_s * H * H) * E_crit_inverse;
}

// E is never negative, so W does not exceed 1. A share that is not a number passes the bounds, so that the
// ECU sees a damaged constant.
float EnergyMargin::evaluate(const Measurement& measured) const {
    const float share = stiffness_share_ * square(measured.roll_angle_rad) +
                        inertia_share_ * square(measured.roll_rate_radps) -
                        gravity_share_ * measured.versine_roll_angle;
    return clamp(1.0F - share, -20.0F, 1.0F);
}

}  // namespace rsi
