// Roll predictor: the load transfer and the extended indicator at the end of a short horizon. By default this
// is what warns.
#pragma once

#include "rsi/indicator/extended_indicator.hpp"
#include "rsi/indicator/load_transfer.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/prediction/steering_demand.hpp"

namespace rsi {

// At the instant of larger load transfer: now, or at the end of the horizon.
struct Prediction {
    float load_transfer_ratio{0.0F};  // signed, -20 to 20
    float rsi_extended{0.0F};         // under that load, 0 to 20
};

// Carries the roll motion forward in one step, with N held:
//   a    = A + A' tau_j (1 - exp(-t/tau_j)), within [min(A, a_d, 0), max(A, a_d, 0)] where a_d is known
//   Ixx y' = m_s H (1 - 3/4 e) (a + N tan x) - M(x) - c_f y,    x' = y,    from x = phi, y = phi'
// by the trapezoidal rule, linearised with the local stiffness. The load transfer is the present one plus
// what the motion changes in alpha A + M(phi) + c_f phi'.
class RollPredictor {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // `load`: that of `motion`. `moment_arm_error`: e of MomentArmError.
    Prediction evaluate(const RollMotion& motion, const TransferredLoad& load, const DemandedForce& demand,
                        float moment_arm_error, const LoadTransfer& load_transfer,
                        const ExtendedIndicator& extended) const;

 private:
    // The moment arm m_s H as corrected by e, and that of gravity.
    struct Arm {
        float force_kgm;
        float gravity_nm;
    };
    struct State {
        float angle_rad;
        float rate_radps;
    };
    float force_change_mps2(const RollMotion& motion, const DemandedForce& demand) const;
    // `force_mps2`: the mean of a over the step.
    State after_step(const State& from, float force_mps2, const Arm& arm,
                     const LoadTransfer& load_transfer) const;

    float step_s_{0.0F};
    float trend_after_step_s_{0.0F};  // tau_j (1 - exp(-t / tau_j)) after it
    float moment_arm_kgm_{0.0F};      // m_s H
    float roll_inertia_kgm2_{1.0F};
    float roll_damping_nmsprad_{0.0F};
};

}  // namespace rsi
