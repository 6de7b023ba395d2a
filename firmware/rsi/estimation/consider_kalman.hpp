// Consider-Kalman filter on the roll centre's vertical movement: one unknown, roll stiffness as a curve, roll
// inertia kept.
#pragma once

#include "rsi/estimation/roll_centre_estimate.hpp"
#include "rsi/estimation/roll_equation.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Knows F[m_s f] dh + d = z, the filtered roll equation. dh is the state, a random process that returns to
// zero; d is the moment of sensor offsets and of a load off the middle, learnt while the vehicle drives
// straight. The errors of the roll stiffness and of d are considered: a turn does not estimate them, but they
// count in the gain and in the deviation, so that a thousand samples of one turn do not pass for a thousand
// independent ones.
class ConsiderKalman {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);
    [[gnu::cold, gnu::noinline]] void reset();

    // Forgets the signals, not what has been learnt: for a gap in the measurements.
    void restart() {
        equation_.restart();
        speed_known_ = false;
    }

    // One sample. `extended_rsi` is that of the cycle before. Near wheel lift and while the speed changes fast
    // dh is held; a number that is not available holds nothing.
    RollCentreEstimate update(const Measurement& measured, float extended_rsi, float speed_mps);

    float movement_m() const { return movement_m_; }  // dh

 private:
    // z against what was expected, and its covariances with what is unknown.
    struct Innovation {
        float value_nm;
        float variance_nm2;
        float with_movement;   // dh, m N m
        float with_stiffness;  // relative error of M(phi), N m
        float with_offset;     // d, (N m)^2
        float weight;          // 1, less for an outlier
    };

    void pass_time(const RollEquation& equation, bool excited, bool held);
    bool changes_speed(float speed_mps);
    Innovation innovation(const RollEquation& equation) const;
    void learn_movement(const RollEquation& equation);
    void learn_offset(const RollEquation& equation);
    bool all_finite(const RollEquation& equation) const;

    FilteredRollEquation equation_{};
    float prior_variance_m2_{0.0F};
    float reversion_{0.0F};         // of dh over one sample without excitation
    float steady_reversion_{0.0F};  // and in a steady turn
    float limit_m_{0.0F};
    float excitation_threshold_n_{0.0F};
    float freeze_level_{0.0F};
    float noise_nm2_{1.0F};  // this one and the next hold what neighbouring samples share
    float damping_noise_nm2s2_{0.0F};
    float offset_prior_nm2_{0.0F};
    float offset_drift_nm2_{0.0F};  // a sample

    bool speed_known_{false};
    float lagged_speed_mps_{0.0F};
    float movement_m_{0.0F};              // dh
    float variance_m2_{0.0F};             // of dh
    float stiffness_covariance_m_{0.0F};  // of dh with the relative error of M(phi)
    float offset_covariance_nm2_{0.0F};   // of dh with d, m N m
    float offset_nm_{0.0F};               // d
    float offset_variance_nm2_{0.0F};     // of d
};

}  // namespace rsi
