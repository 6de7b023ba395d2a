// Roll-plane model with a fixed roll centre, equation (1), and the same model with an additional roll moment,
// (7).
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/model/vehicle.hpp"
#include "rsi/types.hpp"

namespace rsi {

// c_f phi' + K_f phi = H (m_s A + m_s N tan phi) + M_add,  H = h_cg,s - h_frc.
//
// The angle moves by the trapezoidal rule, with the mean of two rates at the angle before: under the forces
// of the sample before and under those of the later one. The part of the angle's own movement in the second
// is linearised upright, with the stiffness K_f - m_s g H where gravity follows the angle, and K_f where it
// does not. Both are stable for any admitted parameters. Clamped to +-0.5 rad: beyond that the vehicle has
// long rolled over and the model means nothing.

// phi_f: the fixed-roll-centre vehicle under the measured forces.
class FixedModelRoll {
 public:
    // The next update finds the vehicle at this angle.
    void reset(float angle_rad);

    // Moves to the instant of the measurement.
    void update(const Vehicle& vehicle, const Measurement& measurement);

    float angle_rad() const { return angle_rad_; }    // phi_f
    float rate_radps() const { return rate_radps_; }  // phi_f'
    float tan_angle() const { return tan_angle_; }

 private:
    float angle_rad_{};
    float rate_radps_{};
    float tan_angle_{};
    bool moving_{false};  // there is a sample before
};

// The low-order model of the paper's Fig. 7: the fixed-roll-centre model's forces and gravity term plus
// M_add.
class CompensatedModelRoll {
 public:
    void reset(float angle_rad);
    // `fixed` must have been updated with the same measurement.
    void update(const Vehicle& vehicle, const Measurement& measurement, const FixedModelRoll& fixed,
                float additional_roll_moment_nm);
    float angle_rad() const { return angle_rad_; }

 private:
    float angle_rad_{};
    float rate_radps_{};
    bool moving_{false};
};

}  // namespace rsi
