// Roll predictor: the largest load transfer towards either side within the horizon. By default this is what
// warns.
#pragma once

#include <cstdint>

#include "rsi/indicator/load_transfer.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/sprung_body.hpp"
#include "rsi/prediction/lateral_response.hpp"
#include "rsi/prediction/steering_demand.hpp"

namespace rsi {

// The largest now or within the horizon.
struct Prediction {
    float load_transfer_ratio{0.0F};  // of larger magnitude, > 0 in a left turn; -20 to 20
    float opposite_ratio{0.0F};       // magnitude of the largest towards the other side, 0 to 20
    float rsi_extended{0.0F};  // now, or under the load transfer of the trend if that is larger; 0 to 20
};

// Carries the roll motion forward, with N held:
//   Ixx y' = m_s H (1 - 3/4 e) (a + N tan x) - M(x) - c_f y,    x' = y,    from x = phi, y = phi'
// by the trapezoidal rule, linearised with the local stiffness. The load transfer is the present one plus
// what the motion changes in alpha A + M(phi) + c_f phi'. There are two forces a:
//   the trend, in one step over the short horizon,
//     a = A + A' tau_j (1 - exp(-t/tau_j)), within [min(A, a_d, 0), max(A, a_d, 0)] where a_d is known;
//   the lateral response, in steps of 40 ms over the long horizon, where steering and response are known.
// Along the response a load transfer counts less by a margin that grows with time: what is further is less
// sure.
class RollPredictor {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // The body from now on.
    void assume_body(const SprungBody& body) {
        moment_arm_kgm_ = body.moment_arm_kgm();
        roll_inertia_kgm2_ = body.roll_inertia_kgm2;
    }

    // `load`: that of `motion`. `response`: none where the course of the force is not known.
    // `moment_arm_error`: e of MomentArmError.
    Prediction evaluate(const RollMotion& motion, const TransferredLoad& load, const DemandedForce& demand,
                        const LateralResponse* response, float moment_arm_error,
                        const LoadTransfer& load_transfer) const;

 private:
    // The roll moment of the sample, and how it follows the motion.
    struct Moments {
        float arm_kgm;        // m_s H as corrected by e
        float gravity_nm;     // N times it
        float suspension_nm;  // at present
        float load_nm;        // at present, what the wheels hold against
        float force_arm_kgm;  // alpha with what e takes from the arm
    };
    struct State {
        float angle_rad;
        float rate_radps;
        RollSpring springs;
    };
    // Load transfers towards either side, as magnitudes.
    struct Sides {
        float right;
        float left;
    };
    float force_change_mps2(const RollMotion& motion, const DemandedForce& demand) const;
    // `force_mps2`: the mean of a over the step.
    State after_step(const State& from, float dt, float force_mps2, const Moments& moments,
                     const LoadTransfer& load_transfer) const;
    float suspension_moment_nm(const State& state) const;
    float load_after(const State& then, float force_change_mps2, const Moments& moments) const;
    void follow_response(const RollMotion& motion, const State& present, const LateralResponse& response,
                         const Moments& moments, const LoadTransfer& load_transfer, Sides& largest) const;

    float trend_horizon_s_{0.0F};
    float trend_after_horizon_s_{0.0F};  // tau_j (1 - exp(-t / tau_j)) after it
    std::uint32_t response_steps_{0U};
    float margin_per_step_{0.0F};
    float moment_arm_kgm_{0.0F};  // m_s H
    float roll_inertia_kgm2_{1.0F};
    float roll_damping_nmsprad_{0.0F};
};

}  // namespace rsi
