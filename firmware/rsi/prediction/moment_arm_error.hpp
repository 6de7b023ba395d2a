// Moment arm error: by which share the calibrated roll equation disagrees with how the vehicle rolls.
#pragma once

#include "rsi/indicator/load_transfer.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/sprung_body.hpp"
#include "rsi/types.hpp"

namespace rsi {

// A vehicle that is loaded otherwise, or whose stiffness is not the calibrated one, rolls more or less than
// m_s H (A + N tan phi) = M(phi) + c_f phi' + Ixx phi'' says. A prediction that starts from the measured roll
// would take the difference for motion to come. This is a slow Kalman filter on the one share e of
//   m_s H (A + N tan phi) - M(phi) - c_f phi' - Ixx phi'' = m_s H (A + N tan phi) e
// whatever its cause. It is no estimate of the roll centre: it is slower than the roll centre moves, and
// holds the errors of K and h as well. Independent of the estimator in use.
class MomentArmError {
 public:
    [[gnu::cold]] void init(const Parameters& parameters) {
        tune(parameters);
        reset();
    }

    // The parameters from now on, with the calibrated body; e stays.
    [[gnu::cold]] void tune(const Parameters& parameters);
    [[gnu::cold, gnu::noinline]] void reset();

    // The body from now on: e is what the load does not explain.
    void assume_body(const SprungBody& body) {
        moment_arm_kgm_ = body.moment_arm_kgm();
        inertia_kgm2_ = body.roll_inertia_kgm2;
    }

    // One sample; `load` is that of `motion`. Learns only from a `measured_angle`: the observer's comes from
    // the calibrated equation itself. Returns e, -0.35 to 0.35.
    float update(const RollMotion& motion, const TransferredLoad& load, bool measured_angle);

 private:
    float moment_arm_kgm_{1.0F};   // m_s H
    float stiffness_noise_{0.0F};  // variances for 1 rad and 1 rad/s, with what neighbouring samples share
    float damping_noise_{0.0F};
    float inertia_kgm2_{0.0F};
    float excitation_nm_{0.0F};
    float noise_nm2_{1.0F};
    float error_{0.0F};     // e
    float variance_{0.0F};  // of e
};

}  // namespace rsi
