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
    RollRisk worst{};  // each of largest magnitude by itself, the present one included
};

// Carries the roll motion forward in eight equal steps:
//   a    = A + A' tau_j (1 - exp(-t/tau_j)), within [min(A, a_d, 0), max(A, a_d, 0)] where a_d is known
//   Ixx y' = m_s H (a + N tan x) - M(x) - c_f y,    x' = y,    from x = phi, y = phi'
// with N held, and evaluates both indicators at the end of each step. The damping is integrated exactly, so
// no admitted damping makes the steps unstable.
class RollPredictor {
 public:
    void init(const Parameters& parameters);

    Prediction evaluate(const RollMotion& motion, const DemandedForce& demand,
                        const LoadTransfer& load_transfer, const ExtendedIndicator& extended) const;

 private:
    float step_s_{0.0F};
    float trend_s_{1.0F};            // tau_j
    float trend_decay_{1.0F};        // exp(-step / tau_j)
    float moment_arm_kgm_{0.0F};     // m_s H
    float rate_gain_radpnms_{0.0F};  // rate that a moment of 1 N m, damped, adds in one step
    float inertia_inverse_{1.0F};    // 1 / Ixx
};

}  // namespace rsi
