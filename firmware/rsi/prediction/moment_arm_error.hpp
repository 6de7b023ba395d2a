// Moment arm error: by which share the calibrated roll equation disagrees with how the vehicle rolls.
#pragma once

#include "rsi/indicator/load_transfer.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/model/vehicle.hpp"
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
    // With the calibrated body.
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        float stiffness_noise{};  // variances for 1 rad and 1 rad/s, with what neighbouring samples share
        float damping_noise{};
        float excitation_nm{};
        float noise_nm2{};
    };

    [[gnu::cold, gnu::noinline]] void reset();

    // One sample; `load` is that of `motion`, and e is what the load does not explain. Learns only
    // from a `measured_angle`: the observer's comes from the calibrated equation itself. Returns e, -0.35 to
    // 0.35.
    float update(const Constants& constants, const LoadedBody& loaded, const RollMotion& motion,
                 const TransferredLoad& load, bool measured_angle);

 private:
    float error_{};     // e
    float variance_{};  // of e
};

}  // namespace rsi
