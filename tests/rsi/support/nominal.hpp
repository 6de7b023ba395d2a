// A large SUV's calibration and ordinary sensor values, as the unit tests use them.
#pragma once

#include <cmath>

#include "rsi/rsi.h"
#include "tests/support/large_suv.h"

namespace rsi_test {

constexpr double gravity_mps2 = 9.80665;
constexpr double pi = 3.14159265358979323846;

inline rsi_parameters large_suv() {
    return rsi_test_large_suv();
}

// The vehicle stands on a flat road.
inline rsi_inputs at_rest() {
    rsi_inputs inputs{};
    inputs.vertical_specific_force_mps2 = static_cast<float>(gravity_mps2);
    return inputs;
}

// The roll angle at which the suspension's curve holds the body on a level road, by bisection:
// M(phi) = m_s H (a_y + g tan phi).
inline double held_roll_angle_rad(const rsi_parameters& p, double lateral_acceleration_mps2) {
    const double arm_nm = static_cast<double>(p.sprung_mass_kg) *
                          static_cast<double>(p.sprung_cg_height_m - p.fixed_roll_centre_height_m);
    double low = -0.3;
    double high = 0.3;
    for (int halving = 0; halving < 60; ++halving) {
        const double phi = 0.5 * (low + high);
        const double z = phi * phi;
        const double moment_nm = phi * (static_cast<double>(p.roll_stiffness_nmprad) +
                                        z * (static_cast<double>(p.roll_stiffness_cubic_nmprad3) +
                                             z * static_cast<double>(p.roll_stiffness_quintic_nmprad5)));
        const bool held = moment_nm > arm_nm * (lateral_acceleration_mps2 + gravity_mps2 * std::tan(phi));
        (held ? high : low) = phi;
    }
    return 0.5 * (low + high);
}

}  // namespace rsi_test
