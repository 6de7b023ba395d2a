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
    RollRisk worst{};  // of largest magnitude within the horizon, the present included
};

// Carries the roll motion forward in four equal steps, with N held:
//   a    = A + A' tau_j (1 - exp(-t/tau_j)), within [min(A, a_d, 0), max(A, a_d, 0)] where a_d is known
//   Ixx y' = m_s H (1 - 3/4 e) (a + N tan x) - M(x) - c_f y,    x' = y,    from x = phi, y = phi'
// by the trapezoidal rule, linearised with the constant stiffness K_f - m_s H g, in four steps within 0.025
// of the converged load transfer where that is below 1. The load transfer is the present one plus what the
// motion changes in alpha A + M(phi) + c_f phi'.
class RollPredictor {
 public:
    void init(const Parameters& parameters);

    // `moment_arm_error`: e of MomentArmError.
    Prediction evaluate(const RollMotion& motion, const DemandedForce& demand,
                        const LoadTransfer& load_transfer, const ExtendedIndicator& extended,
                        float moment_arm_error) const;

 private:
    float half_step_s_{0.0F};
    float trend_s_{1.0F};                  // tau_j
    float trend_decay_{1.0F};              // exp(-step / tau_j)
    float moment_arm_kgm_{0.0F};           // m_s H
    float half_step_stiffness_nms_{0.0F};  // (K_f - m_s H g) step / 2
    float rate_gain_radpnms_{0.0F};        // rate that 1 N m adds in one step
};

}  // namespace rsi
