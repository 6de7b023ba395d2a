// Energy margin: how far the roll energy is from what tips the vehicle, equation (28).
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/types.hpp"

namespace rsi {

// W = (E_crit - E)/E_crit,  E = K_f phi^2/2 - m_s g H (1 - cos phi) + (Ixx + m_s H^2) phi'^2/2,
// E_crit = E(phi_c, 0). As published: linear springs, and blind to the lateral force.
class EnergyMargin {
 public:
    EnergyMargin() = default;
    // With critical_roll_angle_rad() of the same parameters.
    [[gnu::cold]] EnergyMargin(const Parameters& parameters, float critical_roll_angle_rad);

    // 1 at rest, 0 at the critical energy, not below -20.
    float evaluate(const Measurement& measured) const;

    float critical_roll_angle_rad() const { return critical_roll_angle_rad_; }

 private:
    float critical_roll_angle_rad_{};
    // The three terms of E over E_crit.
    float stiffness_share_{};  // for 1 rad^2
    float inertia_share_{};    // about the roll centre, for 1 rad^2/s^2
    float gravity_share_{};    // for a versine of 1
};

}  // namespace rsi
