#include "rsi/indicator/energy_margin.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"
#include "rsi/numeric/square.hpp"

namespace rsi {
namespace {

constexpr float largest_critical_angle_rad = 1.0F;
constexpr int newton_steps = 16;

float moment_arm_m(const Parameters& parameters) {
    return parameters.sprung_cg_height_m - parameters.fixed_roll_centre_height_m;
}

}  // namespace

// In units of m_s g H: r(phi) = k phi - T_0 - q tan phi with q = h_frc/h. r(0) < 0, and r curves one way
// only, so Newton's steps from 0 approach the smallest root from one side.
float critical_roll_angle_rad(const Parameters& parameters) {
    const float H = moment_arm_m(parameters);
    const float k = parameters.roll_stiffness_nmprad / (parameters.sprung_mass_kg * gravity_mps2 * H);
    const float T_0 = 0.5F * parameters.track_width_m / parameters.sprung_cg_height_m;
    const float q = parameters.fixed_roll_centre_height_m / parameters.sprung_cg_height_m;
    float phi = 0.0F;
    float residual = -T_0;
    for (int step = 0; step < newton_steps; ++step) {
        const float tangent = bounded_tangent(phi);
        const float slope = k - q * (1.0F + tangent * tangent);
        phi = clamp(phi - residual / larger(slope, 1.0e-3F), 0.0F, largest_critical_angle_rad);
        residual = k * phi - T_0 - q * bounded_tangent(phi);
    }
    return (absolute(residual) < 1.0e-3F * T_0) ? phi : not_available;
}

void EnergyMargin::init(const Parameters& parameters) {
    const float H = moment_arm_m(parameters);
    const float K_f = parameters.roll_stiffness_nmprad;
    const float m_s = parameters.sprung_mass_kg;
    critical_roll_angle_rad_ = rsi::critical_roll_angle_rad(parameters);
    const float phi_c = critical_roll_angle_rad_;
    const float versine_c = bounded_sine_and_versine(phi_c).versine;
    // K_f >= 1.2 m_s g H is validated, so this energy is positive.
    const float E_crit_inverse = 1.0F / (0.5F * K_f * phi_c * phi_c - m_s * gravity_mps2 * H * versine_c);
    stiffness_share_ = 0.5F * K_f * E_crit_inverse;
    gravity_share_ = m_s * gravity_mps2 * H * E_crit_inverse;
    inertia_share_ = 0.5F * (parameters.roll_inertia_kgm2 + m_s * H * H) * E_crit_inverse;
}

// E is never negative, so W does not exceed 1.
float EnergyMargin::evaluate(const Measurement& measured) const {
    const float share = stiffness_share_ * square(measured.roll_angle_rad) +
                        inertia_share_ * square(measured.roll_rate_radps) -
                        gravity_share_ * measured.versine_roll_angle;
    return larger(1.0F - share, -20.0F);
}

}  // namespace rsi
