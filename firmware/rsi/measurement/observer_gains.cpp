#include "rsi/measurement/observer_gains.hpp"

#include "rsi/numeric/square.hpp"

namespace rsi {
namespace {

constexpr std::uint32_t iterations = 2000U;

using State = ObserverState;

// Propagation of a small error of the state in one step: phi+ = phi + T (w - o) + T/2 d, w+ = w + d,
// d = -s phi - e (w - o), b+ = b + T o, o+ = decay o.
Matrix4 step_of_error(const UprightRoll& roll, float offset_decay) {
    constexpr float T = sample_time_s;
    const float s = roll.stiffness_step;
    const float e = roll.damping_step;
    Matrix4 F;
    F << 1.0F - 0.5F * T * s, T - 0.5F * T * e, 0.0F, 0.5F * T * e - T,  //
        -s, 1.0F - e, 0.0F, e,                                           //
        0.0F, 0.0F, 1.0F, T,                                             //
        0.0F, 0.0F, 0.0F, offset_decay;
    return F;
}

// After this number of iterations.
void settle(const UprightRoll& roll, const ObserverNoise& noise, std::uint32_t count, Matrix4& P,
            ObserverGains& gains) {
    const float s = roll.stiffness_step;
    const Matrix4 F = step_of_error(roll, noise.offset_decay);
    const Vector4 Q{noise.roll_rad2, noise.rate_rad2ps2, noise.bank_rad2, noise.offset_rad2ps2};
    // g (phi + b)
    const Vector4 turn{gravity_mps2, 0.0F, gravity_mps2, 0.0F};
    for (std::uint32_t k = 0U; k < count; ++k) {
        const float roll_variance_before = P(State::roll, State::roll);
        P = F * P * F.transpose();
        P.diagonal() += Q;

        const Vector4 by_gyro = P.col(State::rate);
        const float gyro_variance = by_gyro(State::rate) + noise.gyro_rad2ps2;
        gains.gyro = by_gyro / gyro_variance;
        gains.roll_rate_covariance = by_gyro(State::roll) + s * roll_variance_before;
        gains.rate_variance = gyro_variance - s * s * roll_variance_before;
        gains.roll_growth_rad2 = square(by_gyro(State::roll)) / gyro_variance;
        P -= by_gyro * by_gyro.transpose() / gyro_variance;

        const Vector4 by_turn = P * turn;
        const float turn_variance = turn.dot(by_turn) + noise.turn_mps2_2;
        gains.turn = by_turn;
        gains.turn(State::bank) -= gravity_mps2 * P(State::bank, State::bank);
        gains.bank_growth_rad2 = square(by_turn(State::bank)) / turn_variance;
        P -= by_turn * by_turn.transpose() / turn_variance;
    }
}

Matrix4 initial_covariance() {
    return Vector4{2.5e-3F, 1.0e-4F, 1.0e-2F, 3.0e-4F}.asDiagonal();
}

}  // namespace

void ObserverGainsSearch::begin(const UprightRoll& roll, const ObserverNoise& noise) {
    roll_ = roll;
    noise_ = noise;
    left_ = iterations;
    covariance_ = initial_covariance();
}

bool ObserverGainsSearch::iterate(std::uint32_t at_most) {
    const std::uint32_t count = (at_most < left_) ? at_most : left_;
    settle(roll_, noise_, count, covariance_, gains_);
    left_ -= count;
    return left_ == 0U;
}

ObserverGains steady_observer_gains(const UprightRoll& roll, const ObserverNoise& noise) {
    Matrix4 covariance = initial_covariance();
    ObserverGains gains;
    settle(roll, noise, iterations, covariance, gains);
    return gains;
}

}  // namespace rsi
