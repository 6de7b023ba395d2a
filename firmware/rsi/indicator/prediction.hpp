// Prediction: the load transfer and the extended indicator at their worst within a short horizon.
#pragma once

#include "rsi/indicator/extended_indicator.hpp"
#include "rsi/indicator/load_transfer.hpp"
#include "rsi/indicator/roll_motion.hpp"
#include "rsi/indicator/steering_demand.hpp"

namespace rsi {

struct RollRisk {
    float load_transfer_ratio{0.0F};  // signed, -20 to 20
    float rsi_extended{0.0F};         // 0 to 20
};

struct Prediction {
    RollRisk present{};
    RollRisk worst{};  // of larger magnitude: now, or at the end of the horizon
};

// Carries the roll motion forward in one step, with N held:
//   a    = A + A' tau_j (1 - exp(-t/tau_j)), within [min(A, a_d, 0), max(A, a_d, 0)] where a_d is known
//   Ixx y' = m_s H (1 - 3/4 e) (a + N tan x) - M(x) - c_f y,    x' = y,    from x = phi, y = phi'
// by the trapezoidal rule, linearised with the local stiffness. The load transfer is the present one plus
// what the motion changes in alpha A + M(phi) + c_f phi'.
class RollPredictor {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // `suspension_moment_nm`: that of the present motion. `moment_arm_error`: e of MomentArmError.
    Prediction evaluate(const RollMotion& motion, const DemandedForce& demand,
                        const LoadTransfer& load_transfer, const ExtendedIndicator& extended,
                        float suspension_moment_nm, float moment_arm_error) const;

 private:
    struct Motion {
        float angle_rad;
        float rate_radps;
        float suspension_nm;  // M(x) + c_f y
    };
    // `force_mps2`: the mean of a over the step; `gravity_nm`: the moment arm times N.
    Motion after_step(const Motion& from, float force_mps2, float arm_kgm, float gravity_nm,
                      const LoadTransfer& load_transfer) const;

    float step_s_{0.0F};
    float half_step_s_{0.0F};
    float trend_after_step_s_{0.0F};        // tau_j (1 - exp(-t / tau_j)) after it
    float moment_arm_kgm_{0.0F};            // m_s H
    float inertia_and_damping_kgm2_{1.0F};  // Ixx + c_f step / 2
};

}  // namespace rsi
