// Load transfer from the roll state: (26) without wheel loads.
#pragma once

#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/roll_stiffness_curve.hpp"
#include "rsi/model/sprung_body.hpp"
#include "rsi/model/vehicle_moments.hpp"
#include "rsi/types.hpp"

namespace rsi {

// What the wheels of the two sides hold against each other.
struct TransferredLoad {
    float suspension_moment_nm{0.0F};  // M(phi) + c_f phi'
    float moment_nm{0.0F};             // the weighted mean of both forms below
    float ratio{0.0F};                 // LTR, -20 to 20
};

// LTR = 2 / (m N c_w) moment,  m = m_s + m_u, > 0 in a left turn. The moment that the wheels hold against is
// both
//   alpha A + M(phi) + c_f phi',  alpha = m_s h_frc + m_u h_u:
//       what the links, the springs and the dampers carry from one side to the other, and
//   (m_s h + m_u h_u) A + m_s (h - h_frc) N tan phi - Ixx phi'':
//       what the forces on the vehicle leave after the body's roll acceleration.
// The first is as good as K, the second as good as h; the weighted mean of both errs less than either.
class LoadTransfer {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // The body from now on.
    void assume_body(const SprungBody& body);

    // What springs, stops, bars and dampers hold: M(phi) + c_f phi'. `roll_angle_rad` within 0.5 rad.
    float suspension_moment_nm(float roll_angle_rad, float roll_rate_radps) const {
        return curve_.moment_nm(roll_angle_rad) + roll_damping_nmsprad_ * roll_rate_radps;
    }

    // M(phi) alone and dM/dphi. `roll_angle_rad` within 0.5 rad.
    RollSpring springs(float roll_angle_rad) const { return curve_.at(roll_angle_rad); }

    // At present.
    TransferredLoad evaluate(const RollMotion& motion) const;

    const VehicleMoments& vehicle() const { return vehicle_; }

    // alpha: how much the moment grows for each m/s^2 of A while the suspension's moment stays.
    float force_arm_kgm() const { return force_arm_kgm_; }

    // The ratio for such a moment, -20 to 20.
    float ratio(float moment_nm, float normal_force_mps2) const;

 private:
    RollStiffnessCurve curve_{};
    VehicleMoments vehicle_{};
    float inertial_weight_{0.0F};
    float force_arm_kgm_{0.0F};  // alpha
    float roll_stiffness_nmprad_{0.0F};
    float roll_damping_nmsprad_{0.0F};
    // What a load leaves.
    float roll_centre_height_m_{0.0F};  // h_frc
    float half_track_m_{1.0F};
    float unsprung_mass_kg_{0.0F};
    float unsprung_moment_kgm_{0.0F};  // m_u h_u
};

}  // namespace rsi
