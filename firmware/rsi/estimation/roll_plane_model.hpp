// Roll-plane model with a fixed roll centre, equation (1), and the same model with an additional roll moment,
// (7).
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/model/sprung_body.hpp"
#include "rsi/types.hpp"

namespace rsi {

// c_f phi' + K_f phi = H (m_s A + m_s N tan phi) + M_add,  H = h_cg,s - h_frc.
// Constant but for the load; the states that it moves are the callers'.
class RollPlaneModel {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // The body from now on.
    void assume_body(const SprungBody& body);

    float moment_arm_m() const { return moment_arm_m_; }  // H
    float sprung_mass_kg() const { return sprung_mass_kg_; }
    float stiffness_nmprad() const { return stiffness_nmprad_; }
    float damping_nmsprad() const { return damping_nmsprad_; }

    // phi' at `angle_rad`; `tan_gravity_angle` is the tangent in the gravity term.
    float roll_rate_radps(float angle_rad, float tan_gravity_angle, const Measurement& measurement,
                          float additional_roll_moment_nm) const;

    // The angle one sample later by the trapezoidal rule. `rate_radps` is the mean of two rates, both at
    // `angle_rad`: under the forces of the sample before and under those of the later one. What the angle's
    // own movement adds to the second is linearised upright, with the stiffness K_f - m_s g H where gravity
    // follows the angle, and K_f where it does not. Both are stable for any admitted parameters. Clamped to
    // +-0.5 rad: beyond that the vehicle has long rolled over and the model means nothing.
    float next_upright_angle_rad(float angle_rad, float rate_radps) const;
    float next_spring_angle_rad(float angle_rad, float rate_radps) const;

 private:
    float sprung_mass_kg_{0.0F};
    float moment_arm_m_{0.0F};
    float stiffness_nmprad_{1.0F};
    float damping_nmsprad_{1.0F};
    float damping_inverse_{1.0F};
    float force_to_rate_{0.0F};        // m_s H / c_f
    float angle_to_rate_per_s_{0.0F};  // K_f / c_f
    float upright_step_s_{0.0F};       // the sample time over 1 + half of it times the stiffness over c_f
    float spring_step_s_{0.0F};
};

// phi_f: the fixed-roll-centre vehicle under the measured forces.
class FixedModelRoll {
 public:
    // Where the next update finds the vehicle.
    void reset(float angle_rad);

    // Moves to the instant of the measurement.
    void update(const RollPlaneModel& model, const Measurement& measurement);

    float angle_rad() const { return angle_rad_; }    // phi_f
    float rate_radps() const { return rate_radps_; }  // phi_f'
    float tan_angle() const { return tan_angle_; }

 private:
    float angle_rad_{0.0F};
    float rate_radps_{0.0F};
    float tan_angle_{0.0F};
    bool moving_{false};  // there is a sample before
};

// The low-order model of the paper's Fig. 7: the fixed-roll-centre model's forces and gravity term plus
// M_add.
class CompensatedModelRoll {
 public:
    void reset(float angle_rad);
    // `fixed` must have been updated with the same measurement.
    void update(const RollPlaneModel& model, const Measurement& measurement, const FixedModelRoll& fixed,
                float additional_roll_moment_nm);
    float angle_rad() const { return angle_rad_; }

 private:
    float angle_rad_{0.0F};
    float rate_radps_{0.0F};
    bool moving_{false};
};

}  // namespace rsi
