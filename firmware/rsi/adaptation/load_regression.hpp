// Load regression: by how much m_s H differs from the calibration, learnt from ordinary driving.
#pragma once

#include "rsi/indicator/load_transfer.hpp"
#include "rsi/measurement/roll_motion.hpp"
#include "rsi/numeric/matrix.hpp"
#include "rsi/types.hpp"

namespace rsi {

// The roll equation of a vehicle that carries a load, divided by the calibrated m_s H:
//   [M(phi) + c_f phi' + Ixx phi''] / (m_s H) - f = x f + d,   f = A + N tan phi.
// A load leaves the springs as they are, so the suspension's moment shows by how much it makes m_s H larger.
// d is what the offsets of the sensors and a load off the middle do. It is the paper's regression (5), Y =
// psi^T theta with psi = [f; 1] and theta = [x; d], with what a drive can tell apart alone, and its recursion
// (9), (10) without forgetting: theta is taken to wander slowly instead, so that P cannot grow without bound.
// Slow, because only what lasts is a load: the roll centre moves within every turn.
class LoadRegression {
 public:
    // With the calibrated body.
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        float moment_to_force{};       // 1 / (m_s H)
        float inertia_to_force_m{};    // Ixx / (m_s H)
        float damping_to_force_mps{};  // c_f / (m_s H)
    };

    LoadRegression() { reset(); }

    [[gnu::cold, gnu::noinline]] void reset();

    // One sample; `load` is that of `motion`. Learns only in ordinary turns, 0.8 < |A| < 4 m/s^2. False when
    // a number was none and everything has been forgotten.
    bool update(const Constants& constants, const RollMotion& motion, const TransferredLoad& load);

    // As update() where there is nothing to learn from.
    void pass_time();

    // The load may have changed: half of it is kept, and it is known less well. `expected`: the excess that
    // is likeliest without any driving.
    [[gnu::cold, gnu::noinline]] void doubt(float expected);

    // Moves x by what a new expectation says, as far as driving has not shown it.
    void expect_change(float change);

    // A load has been put on, or taken off: x changes as much, give or take half of it.
    [[gnu::cold, gnu::noinline]] void add_load(float change);

    float excess() const { return theta_(excess_at); }
    float excess_deviation() const;

    LearntLoad learnt() const;  // x, its deviation and d
    // False, and nothing is taken over, where a number cannot be one that was learnt.
    [[gnu::cold, gnu::noinline]] bool restore(const LearntLoad& learnt);

 private:
    static constexpr Eigen::Index excess_at = 0;
    static constexpr Eigen::Index offset_at = 1;

    void learn(const Vector2& psi, float output_mps2, float noise_mps4);
    bool keep_in_bounds();

    Vector2 theta_{Vector2::Zero()};
    Matrix2 covariance_{Matrix2::Identity()};
};

}  // namespace rsi
