// Vehicle: the numbers of its springs, axles and sprung body that the equations of all stages share.
#pragma once

#include "rsi/model/roll_stiffness_curve.hpp"
#include "rsi/model/vehicle_lengths.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The part of the vehicle that a load changes.
struct SprungBody {
    float mass_kg{};            // m_s
    float cg_height_m{};        // h_cg,s above the road
    float roll_arm_m{};         // H
    float roll_inertia_kgm2{};  // Ixx

    float moment_arm_kgm() const { return mass_kg * roll_arm_m; }  // m_s H
};

constexpr SprungBody calibrated_body(const Parameters& parameters) {
    return SprungBody{parameters.sprung_mass_kg, parameters.sprung_cg_height_m, roll_arm_m(parameters),
                      parameters.roll_inertia_kgm2};
}

// Springs, dampers, axles and the roll centre: as calibrated, whatever the vehicle carries.
struct Suspension {
    Suspension() = default;
    [[gnu::cold]] explicit Suspension(const Parameters& parameters);

    RollStiffnessCurve springs;
    float stiffness_nmprad{};      // K_f
    float damping_nmsprad{};       // c_f
    float damping_inverse{};       // 1 / c_f
    float angle_to_rate_per_s{};   // K_f / c_f
    float spring_step_s{};         // the sample time over 1 + half of it times K_f / c_f
    float roll_centre_height_m{};  // h_frc
    float half_track_m{};          // c_w / 2
    float unsprung_mass_kg{};      // m_u
    float unsprung_moment_kgm{};   // m_u h_u
};

// The part of the equations' numbers that changes with the body.
struct LoadedBody {
    SprungBody body{};
    float cg_height_inverse{};  // 1 / h_cg,s
    float moment_arm_kgm{};     // m_s H: of N tan phi
    float height_moment_kgm{};  // m_s h + m_u h_u: of A
    float half_weight_kgm{};    // (m_s + m_u) c_w / 2: of N, all of it on one side's wheels
    float force_arm_kgm{};      // alpha = m_s h_frc + m_u h_u: of A while the suspension's moment stays
    float force_to_rate{};      // m_s H / c_f
    float upright_step_s{};     // as spring_step_s, with gravity's share of the stiffness
};

LoadedBody loaded_body(const Suspension& suspension, const SprungBody& body);

struct Vehicle {
    Vehicle() = default;
    // As calibrated.
    [[gnu::cold]] explicit Vehicle(const Parameters& parameters)
        : suspension(parameters), loaded(loaded_body(suspension, calibrated_body(parameters))) {}

    // M(phi) + c_f phi': what springs, stops, bars and dampers hold. `roll_angle_rad` within 0.5 rad.
    float suspension_moment_nm(float roll_angle_rad, float roll_rate_radps) const {
        return suspension.springs.moment_nm(roll_angle_rad) + suspension.damping_nmsprad * roll_rate_radps;
    }

    Suspension suspension;
    LoadedBody loaded{};
};

}  // namespace rsi
