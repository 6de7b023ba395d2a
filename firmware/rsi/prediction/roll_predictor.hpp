// Roll predictor: the largest load transfer towards either side within the horizon. By default this is what
// warns.
#pragma once

#include <cstdint>

#include "rsi/indicator/load_transfer.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/vehicle.hpp"
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
// sure. The larger of both, P, is then moved towards the linear forecast F, by at most a share of itself:
//   P + s (F - P)  within  (1 - b/4) P .. (1 + b) P,    s = forecast_share, b = forecast_limit.
class RollPredictor {
 public:
    RollPredictor() = default;
    [[gnu::cold]] explicit RollPredictor(const Parameters& parameters);

    // `load`: that of `motion`. `target`: none where the course of the force is not known.
    // `moment_arm_error`: e of MomentArmError. `forecast`: of LinearForecast.
    Prediction evaluate(const Vehicle& vehicle, const RollMotion& motion, const TransferredLoad& load,
                        const DemandedForce& demand, const LateralResponse& response,
                        const ForceTarget* target, float moment_arm_error, float forecast) const;

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
    static State after_step(const Vehicle& vehicle, const State& from, float dt, float force_mps2,
                            const Moments& moments);
    static float load_after(const Vehicle& vehicle, const State& then, float force_change_mps2,
                            const Moments& moments);
    void follow_response(const Vehicle& vehicle, const RollMotion& motion, const State& present,
                         const LateralResponse& response, const ForceTarget& target, const Moments& moments,
                         Sides& largest) const;
    float towards(float predicted, float forecast) const;

    float trend_horizon_s_{};
    float trend_after_horizon_s_{};  // tau_j (1 - exp(-t / tau_j)) after it
    std::uint32_t response_steps_{};
    float margin_per_step_{};
    float forecast_share_{};
    float forecast_limit_{};
};

}  // namespace rsi
