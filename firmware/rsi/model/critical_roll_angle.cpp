#include "rsi/model/critical_roll_angle.hpp"

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/bounded_functions.hpp"

namespace rsi {
namespace {

constexpr float largest_critical_angle_rad = 1.0F;
constexpr int newton_steps = 16;

}  // namespace

// In units of m_s g H: r(phi) = k phi - T_0 - q tan phi with q = h_frc/h. r(0) < 0, and r curves one way
// only, so Newton's steps from 0 approach the smallest root from one side.
float critical_roll_angle_rad(const Parameters& parameters) {
    const float H = roll_arm_m(parameters);
    const float k = parameters.roll_stiffness_nmprad / (parameters.sprung_mass_kg * gravity_mps2 * H);
    const float T_0 = static_stability_factor(parameters);
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

}  // namespace rsi
