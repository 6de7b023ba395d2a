// Inclination: of the body against the horizon, as the lateral force shows it.
#pragma once

#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// Lateral force in excess of the turn, expressed as a tilt of gravity; not available where it is
// more than 0.6 of that. It takes a slide for an inclination, and so is no proof of one.
inline float inclination_rad(float lateral_force_mps2, float turn_mps2) noexcept {
    constexpr float per_gravity = 1.0F / rsi::gravity_mps2;
    const float sine = (lateral_force_mps2 - turn_mps2) * per_gravity;
    return rsi::is_within_magnitude(sine, 0.6F) ? sine * (1.0F + sine * sine * (1.0F / 6.0F))
                                                : rsi::not_available;
}

}  // namespace rsi::monitoring
