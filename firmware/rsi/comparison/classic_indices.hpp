// Classic indices: what the paper compares its indicator with, as far as a vehicle can compute it.
#pragma once

#include "rsi/comparison/energy_margin.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/types.hpp"

namespace rsi {

class ClassicIndices {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // As init, but keeps what is found by iterating.
    [[gnu::cold]] void reinitialise(const Parameters& parameters);

    // Writes its indices; rsi_outputs.h says what each is, classic_indices.cpp has the formulas. Those without a
    // derivative take the measurement as it is, those with phi'' the motion, whose signals all have the same
    // delay.
    void evaluate(const Measurement& measured, const RollMotion& motion, Outputs& outputs) const;

 private:
    float rollover_index(const Measurement& measured) const;
    float time_to_rollover_s(const Measurement& measured) const;

    EnergyMargin energy_{};
    float static_stability_factor_{1.0F};  // c_w / (2 h)
    float static_stability_gain_{0.0F};    // 1 / (g SSF)
    float inertia_share_s2prad_{0.0F};     // Ixx / (m_s g h)
    float angle_gain_{0.0F};               // C_1 / phi_th
    float rate_gain_{0.0F};                // C_1 / phi'_th
    float acceleration_gain_{0.0F};        // C_2 / a_yc
    float direction_weight_{0.0F};         // 1 - C_1 - C_2
    float gate_slope_radps_{0.0F};         // k_1
};

}  // namespace rsi
