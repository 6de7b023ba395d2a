#include "rsi/indicator/energy_margin.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"

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
    roll_stiffness_nmprad_ = parameters.roll_stiffness_nmprad;
    gravity_moment_nm_ = parameters.sprung_mass_kg * gravity_mps2 * H;
    roll_inertia_kgm2_ = parameters.roll_inertia_kgm2 + parameters.sprung_mass_kg * H * H;
    critical_roll_angle_rad_ = rsi::critical_roll_angle_rad(parameters);
    // K_f >= 1.2 m_s g H is validated, so this energy is positive.
    critical_energy_inverse_ = 1.0F / energy_nm(critical_roll_angle_rad_, 0.0F);
}

float EnergyMargin::energy_nm(float roll_angle_rad, float roll_rate_radps) const {
    // 1 - cos phi = 2 sin^2(phi/2) keeps its digits near zero.
    const float half_sine = bounded_sine(0.5F * roll_angle_rad);
    return 0.5F * (roll_stiffness_nmprad_ * roll_angle_rad * roll_angle_rad +
                   roll_inertia_kgm2_ * roll_rate_radps * roll_rate_radps) -
           2.0F * gravity_moment_nm_ * half_sine * half_sine;
}

float EnergyMargin::evaluate(float roll_angle_rad, float roll_rate_radps) const {
    return clamp(1.0F - energy_nm(roll_angle_rad, roll_rate_radps) * critical_energy_inverse_, -20.0F, 1.0F);
}

}  // namespace rsi
