// Load regression: recursive estimate of the load excess x, the share by which m_s H exceeds the calibrated
// one.
#pragma once

#include "rsi/indicator/load_transfer.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/numeric/matrix.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The roll equation of a vehicle that carries a load, divided by the calibrated m_s H:
//   [M(phi) + c_f phi' + Ixx phi''] / (m_s H) - f = x f + d,   f = A + N tan phi.
// A load does not change the springs, so the suspension moment shows the increase of m_s H. d is the effect
// of sensor offsets and an off-centre load. This is the paper's regression (5), Y = psi^T theta, reduced to
// what ordinary driving can identify, psi = [f; 1] and theta = [x; d], and its recursion (9), (10) with a
// slow random walk of theta instead of forgetting, so that P stays bounded. The walk is slow because a load
// is constant, whereas the roll centre moves within every turn.
class LoadRegression {
 public:
    // From the calibrated body.
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        float moment_to_force{};       // 1 / (m_s H)
        float inertia_to_force_m{};    // Ixx / (m_s H)
        float damping_to_force_mps{};  // c_f / (m_s H)
    };

    LoadRegression() { reset(); }

    [[gnu::cold, gnu::noinline]] void reset();

    // One sample. `load`: load transfer of the same sample as `motion`. Learns only in ordinary turns, 0.8 <
    // |A| < 4 m/s^2. False when a value was not finite and the estimate has been reset.
    bool update(const Constants& constants, const RollMotion& motion, const TransferredLoad& load);

    // A sample without a measurement: only the random walk raises the variances.
    void pass_time();

    // The load may have changed: moves the excess halfway to `expected`, the excess from the received mass
    // alone, and raises the variances.
    [[gnu::cold, gnu::noinline]] void doubt(float expected);

    // Adds `change` to the prior of x: x moves by the share of it that driving has not replaced yet.
    void expect_change(float change);

    // A load was added or removed: x changes by `change`, with a standard deviation of half of it.
    [[gnu::cold, gnu::noinline]] void add_load(float change);

    float excess() const { return theta_(excess_at); }
    float excess_deviation() const;

    // Part of x that received masses suggest and driving has not replaced yet.
    float assumed_excess() const { return assumed_; }

    LearntLoad learnt() const;  // x, its deviation and d
    // False, with nothing restored, for values out of range.
    [[gnu::cold, gnu::noinline]] bool restore(const LearntLoad& learnt);

 private:
    static constexpr Eigen::Index excess_at = 0;
    static constexpr Eigen::Index offset_at = 1;

    void learn(const Vector2& psi, float output_mps2, float noise_mps4);
    bool keep_in_bounds();
    [[gnu::cold, gnu::noinline]] void assume(float change);

    Vector2 theta_{Vector2::Zero()};
    Matrix2 covariance_{Matrix2::Identity()};
    float assumed_{0.0F};
};

}  // namespace rsi
