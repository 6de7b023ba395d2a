// Sprung body: what of the vehicle a load changes.
#pragma once

#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Springs, dampers, axles and the roll centre stay as calibrated, whatever the vehicle carries.
struct SprungBody {
    float mass_kg{1.0F};            // m_s
    float cg_height_m{1.0F};        // h_cg,s above the road
    float roll_arm_m{1.0F};         // H
    float roll_inertia_kgm2{1.0F};  // Ixx

    float moment_arm_kgm() const { return mass_kg * roll_arm_m; }  // m_s H
};

constexpr SprungBody calibrated_body(const Parameters& parameters) {
    return SprungBody{parameters.sprung_mass_kg, parameters.sprung_cg_height_m, roll_arm_m(parameters),
                      parameters.roll_inertia_kgm2};
}

}  // namespace rsi
