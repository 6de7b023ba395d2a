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
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        FilteredRollEquation::Constants equation;
        float prior_variance_m2{};
        float reversion{};         // of dh over one sample without excitation
        float steady_reversion{};  // and in a steady turn
        float limit_m{};
        float excitation_threshold_n{};
        float freeze_level{};
        float noise_nm2{};  // this one and the next hold what neighbouring samples share
        float damping_noise_nm2s2{};
        float offset_prior_nm2{};
        float offset_drift_nm2{};  // a sample
    };

    [[gnu::cold, gnu::noinline]] void reset(const Constants& constants);

    // Forgets the signals, not what has been learnt: for a gap in the measurements.
    void reset_signals() {
        equation_.reset();
        speed_known_ = false;
    }

    // One sample. With the load in `vehicle`, dh is what the load does not explain. `extended_rsi` is that of
    // the cycle before. Near wheel lift and while the speed changes fast dh is held; a number that is not
    // available holds nothing.
    RollCentreEstimate update(const Constants& constants, const Vehicle& vehicle, const Measurement& measured,
                              float extended_rsi, float speed_mps);

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

    void pass_time(const Constants& constants, const RollEquation& equation, bool excited, bool held);
    bool changes_speed(float speed_mps);
    Innovation innovation(const Constants& constants, const RollEquation& equation) const;
    void learn(Eigen::Index which, const Innovation& innovation);
    void keep_in_bounds(const Constants& constants);
    bool all_finite(const RollEquation& equation) const;

    FilteredRollEquation equation_{};
    bool speed_known_{false};
    float lagged_speed_mps_{};
    Vector3 state_{
        Vector3::Zero()};  // dh (m), nothing, d (N m): the error of M(phi) is considered, not estimated
    Matrix3 covariance_{Matrix3::Identity()};
};

}  // namespace rsi
