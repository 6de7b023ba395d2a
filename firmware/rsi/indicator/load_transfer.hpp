// Load transfer from the roll state: (26) without wheel loads.
#pragma once

#include "rsi/model/roll_stiffness_curve.hpp"
#include "rsi/types.hpp"

namespace rsi {

// LTR_int = 2 / (m N c_w) [alpha A + M(phi) + c_f phi'],  alpha = m_s h_frc + m_u h_u,  m = m_s + m_u:
// what the links, the springs and the dampers carry from one side to the other. > 0 in a left turn.
class LoadTransfer {
 public:
    void init(const Parameters& parameters);

    // What springs, stops, bars and dampers hold: M(phi) + c_f phi'. `roll_angle_rad` within 0.5 rad.
    float suspension_moment_nm(float roll_angle_rad, float roll_rate_radps) const {
        return curve_.moment_nm(roll_angle_rad) + roll_damping_nmsprad_ * roll_rate_radps;
    }

    // The bracket: the moment that the wheels hold against.
    float moment_nm(float parallel_force_mps2, float suspension_moment_nm) const {
        return force_arm_kgm_ * parallel_force_mps2 + suspension_moment_nm;
    }

    // The ratio for such a moment, -20 to 20. `normal_inverse` is 1/N.
    float ratio(float moment_nm, float normal_inverse) const;

 private:
    RollStiffnessCurve curve_{};
    float force_arm_kgm_{0.0F};  // alpha
    float roll_damping_nmsprad_{0.0F};
    float half_weight_arm_kgm_{1.0F};  // m c_w / 2
};

}  // namespace rsi
