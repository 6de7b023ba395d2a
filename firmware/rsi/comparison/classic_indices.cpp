#include "rsi/comparison/classic_indices.hpp"

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/square.hpp"
#include "rsi/numeric/square_root.hpp"

namespace rsi {
namespace {

constexpr float largest_index = 20.0F;
constexpr float longest_time_s = 10.0F;
// A product of two numbers that exceeds it leaves the sum of their squares above zero.
constexpr float smallest_product = 1.0e-20F;

}  // namespace

ClassicIndices::ClassicIndices(const Parameters& parameters, float critical_roll_angle_rad)
    : energy_(parameters, critical_roll_angle_rad),
      static_stability_factor_(static_stability_factor(parameters)),
      static_stability_gain_(1.0F / (gravity_mps2 * static_stability_factor_)),
      inertia_share_s2prad_(parameters.roll_inertia_kgm2 /
                            (parameters.sprung_mass_kg * gravity_mps2 * parameters.sprung_cg_height_m)),
      angle_gain_(parameters.rollover_index_angle_weight / parameters.rollover_index_roll_angle_rad),
      rate_gain_(parameters.rollover_index_angle_weight / parameters.rollover_index_roll_rate_radps),
      acceleration_gain_(parameters.rollover_index_acceleration_weight /
                         parameters.rollover_index_acceleration_mps2),
      direction_weight_(1.0F - parameters.rollover_index_angle_weight -
                        parameters.rollover_index_acceleration_weight),
      gate_slope_radps_(parameters.rollover_index_slope_radps) {}

void ClassicIndices::evaluate(const Measurement& measured, const RollMotion& motion, Outputs& outputs) const {
    outputs.static_stability_level =
        smaller(absolute(measured.lateral_acceleration_mps2) * static_stability_gain_, largest_index);
    // (27): a_y/g -+ Ixx phi''/(m_s g h). Roll that speeds up outwards takes load transfer away: minus.
    const float force_share = motion.lateral_acceleration_mps2 * (1.0F / gravity_mps2);
    const float inertia_share = inertia_share_s2prad_ * motion.roll_acceleration_radps2;
    outputs.dynamic_stability_index = clamp_magnitude(force_share - inertia_share, largest_index);
    outputs.dynamic_stability_index_late = clamp_magnitude(force_share + inertia_share, largest_index);
    outputs.energy_margin = energy_.evaluate(measured);
    outputs.rollover_index = rollover_index(measured);
    outputs.time_to_rollover_s = time_to_rollover_s(measured);
}

// (29): C_1 (|phi|/phi_th + |phi'|/phi'_th) + C_2 |a_y|/a_yc + (1 - C_1 - C_2) |phi|/sqrt(phi^2 + phi'^2)
// while phi (phi' - k_1 phi) > 0, otherwise 0.
float ClassicIndices::rollover_index(const Measurement& measured) const {
    const float phi = measured.roll_angle_rad;
    const float rate = measured.roll_rate_radps;
    if (!(phi * (rate - gate_slope_radps_ * phi) > smallest_product)) {
        return 0.0F;
    }
    const float index = angle_gain_ * absolute(phi) + rate_gain_ * absolute(rate) +
                        acceleration_gain_ * absolute(measured.lateral_acceleration_mps2) +
                        direction_weight_ * absolute(phi) / square_root(square(phi) + square(rate));
    return smaller(index, largest_index);
}

// (phi_c - |phi|)/|phi'| while the body rolls outwards; none is left once the CG stands outside the wheels.
float ClassicIndices::time_to_rollover_s(const Measurement& measured) const {
    if (absolute(measured.tan_roll_angle) >= static_stability_factor_) {
        return 0.0F;
    }
    if (!(measured.roll_angle_rad * measured.roll_rate_radps > 0.0F)) {
        return longest_time_s;
    }
    const float angle_left_rad =
        larger(energy_.critical_roll_angle_rad() - absolute(measured.roll_angle_rad), 0.0F);
    const float rate_radps = absolute(measured.roll_rate_radps);
    // Compared before it is divided: the rate may be as small as a float can be.
    return (angle_left_rad < longest_time_s * rate_radps) ? angle_left_rad / rate_radps : longest_time_s;
}

}  // namespace rsi
