// Classic indices: what the paper compares its indicator with, as far as a vehicle can compute it.
#pragma once

#include "rsi/comparison/energy_margin.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/types.hpp"

namespace rsi {

class ClassicIndices {
 public:
    ClassicIndices() = default;
    // With critical_roll_angle_rad() of the same parameters.
    [[gnu::cold]] ClassicIndices(const Parameters& parameters, float critical_roll_angle_rad);

    // Writes its indices; rsi_outputs.h says what each is, classic_indices.cpp has the formulas. Those
    // without a derivative take the measurement as it is, those with phi'' the motion, whose signals all have
    // the same delay.
    void evaluate(const Measurement& measured, const RollMotion& motion, Outputs& outputs) const;

    float critical_roll_angle_rad() const { return energy_.critical_roll_angle_rad(); }

 private:
    float rollover_index(const Measurement& measured) const;
    float time_to_rollover_s(const Measurement& measured) const;

    EnergyMargin energy_;
    float static_stability_factor_{};  // c_w / (2 h)
    float static_stability_gain_{};    // 1 / (g SSF)
    float inertia_share_s2prad_{};     // Ixx / (m_s g h)
    float angle_gain_{};               // C_1 / phi_th
    float rate_gain_{};                // C_1 / phi'_th
    float acceleration_gain_{};        // C_2 / a_yc
    float direction_weight_{};         // 1 - C_1 - C_2
    float gate_slope_radps_{};         // k_1
};

}  // namespace rsi
