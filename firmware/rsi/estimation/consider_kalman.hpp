// Consider-Kalman filter on the roll centre's vertical movement: one unknown, roll stiffness as a curve, roll
// inertia kept.
#pragma once

#include "rsi/estimation/roll_centre_estimate.hpp"
#include "rsi/estimation/roll_equation.hpp"
#include "rsi/numeric/matrix.hpp"
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

    // The parameters from now on; signals and what has been learnt stay.
    [[gnu::cold]] void tune(const Parameters& parameters);
    [[gnu::cold, gnu::noinline]] void reset();

    // Forgets the signals, not what has been learnt: for a gap in the measurements.
    void restart() {
        equation_.restart();
        speed_known_ = false;
    }

    // The body from now on: dh is what the load does not explain.
    void assume_body(const SprungBody& body) { equation_.assume_body(body); }

    // One sample. `extended_rsi` is that of the cycle before. Near wheel lift and while the speed changes
    // fast dh is held; a number that is not available holds nothing.
    RollCentreEstimate update(const Measurement& measured, float extended_rsi, float speed_mps);

    float movement_m() const { return state_(movement); }  // dh

 private:
    // Places in the state and its covariance.
    static constexpr Eigen::Index movement = 0;   // dh
    static constexpr Eigen::Index stiffness = 1;  // relative error of M(phi)
    static constexpr Eigen::Index offset = 2;     // d

    // z against what was expected.
    struct Innovation {
        float value_nm{0.0F};
        float variance_nm2{0.0F};
        float weight{1.0F};  // less for an outlier
        Vector3 covariance;  // with the state
    };

    void pass_time(const RollEquation& equation, bool excited, bool held);
    bool changes_speed(float speed_mps);
    Innovation innovation(const RollEquation& equation) const;
    void learn(Eigen::Index which, const Innovation& innovation);
    void keep_in_bounds();
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
    Vector3 state_{
        Vector3::Zero()};  // dh (m), nothing, d (N m): the error of M(phi) is considered, not estimated
    Matrix3 covariance_{Matrix3::Identity()};
};

}  // namespace rsi
