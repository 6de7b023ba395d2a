#include "rsi/measurement/observer_gains.hpp"

namespace rsi {
namespace {

constexpr int iterations = 2000;

// One triangle of the covariance of [phi, w, b, o], so it cannot become unsymmetric.
struct Covariance4 {
    float P11{2.5e-3F}, P12{0.0F}, P13{0.0F}, P14{0.0F};
    float P22{1.0e-4F}, P23{0.0F}, P24{0.0F};
    float P33{1.0e-2F}, P34{0.0F};
    float P44{3.0e-4F};
};

// F P F^T + Q with F = [[1 - T/2 s, T - T/2 e, 0, -(T - T/2 e)], [-s, 1 - e, 0, e], [0, 0, 1, T],
// [0, 0, 0, decay]].
Covariance4 predicted(const Covariance4& P, const UprightRoll& roll, const ObserverNoise& noise) {
    constexpr float T = sample_time_s;
    const float s = roll.stiffness_step;
    const float e = roll.damping_step;
    const float decay = noise.offset_decay;
    const float F11 = 1.0F - 0.5F * T * s;
    const float F12 = T - 0.5F * T * e;
    const float a1 = F11 * P.P11 + F12 * (P.P12 - P.P14);
    const float a2 = F11 * P.P12 + F12 * (P.P22 - P.P24);
    const float a3 = F11 * P.P13 + F12 * (P.P23 - P.P34);
    const float a4 = F11 * P.P14 + F12 * (P.P24 - P.P44);
    const float b1 = P.P12 + e * (P.P14 - P.P12) - s * P.P11;
    const float b2 = P.P22 + e * (P.P24 - P.P22) - s * P.P12;
    const float b3 = P.P23 + e * (P.P34 - P.P23) - s * P.P13;
    const float b4 = P.P24 + e * (P.P44 - P.P24) - s * P.P14;
    const float c3 = P.P33 + T * P.P34;
    const float c4 = P.P34 + T * P.P44;
    Covariance4 next;
    next.P11 = F11 * a1 + F12 * (a2 - a4) + noise.roll_rad2;
    next.P12 = a2 + e * (a4 - a2) - s * a1;
    next.P13 = a3 + T * a4;
    next.P14 = decay * a4;
    next.P22 = b2 + e * (b4 - b2) - s * b1 + noise.rate_rad2ps2;
    next.P23 = b3 + T * b4;
    next.P24 = decay * b4;
    next.P33 = c3 + T * c4 + noise.bank_rad2;
    next.P34 = decay * c4;
    next.P44 = decay * decay * P.P44 + noise.offset_rad2ps2;
    return next;
}

// After a scalar measurement; c = P h, the covariance of state and innovation.
Covariance4 corrected(const Covariance4& P, const float (&c)[4], float innovation_variance) {
    const float weight = 1.0F / innovation_variance;
    Covariance4 next;
    next.P11 = P.P11 - weight * c[0] * c[0];
    next.P12 = P.P12 - weight * c[0] * c[1];
    next.P13 = P.P13 - weight * c[0] * c[2];
    next.P14 = P.P14 - weight * c[0] * c[3];
    next.P22 = P.P22 - weight * c[1] * c[1];
    next.P23 = P.P23 - weight * c[1] * c[2];
    next.P24 = P.P24 - weight * c[1] * c[3];
    next.P33 = P.P33 - weight * c[2] * c[2];
    next.P34 = P.P34 - weight * c[2] * c[3];
    next.P44 = P.P44 - weight * c[3] * c[3];
    return next;
}

}  // namespace

ObserverGains steady_observer_gains(const UprightRoll& roll, const ObserverNoise& noise) {
    const float s = roll.stiffness_step;
    Covariance4 P;
    ObserverGains gains;
    for (int k = 0; k < iterations; ++k) {
        const float P11_before = P.P11;
        const Covariance4 p = predicted(P, roll, noise);
        const float by_rate[4] = {p.P12, p.P22, p.P23, p.P24};
        const float rate_variance = p.P22 + noise.gyro_rad2ps2;
        const Covariance4 q = corrected(p, by_rate, rate_variance);
        gains.roll_rate_covariance = p.P12 + s * P11_before;
        gains.rate_variance = rate_variance - s * s * P11_before;
        gains.rate = p.P22 / rate_variance;
        gains.bank = p.P23 / rate_variance;
        gains.offset = p.P24 / rate_variance;
        gains.roll_growth_rad2 = p.P12 * p.P12 / rate_variance;
        const float by_turn[4] = {gravity_mps2 * (q.P11 + q.P13), gravity_mps2 * (q.P12 + q.P23),
                                  gravity_mps2 * (q.P13 + q.P33), gravity_mps2 * (q.P14 + q.P34)};
        const float turn_variance = gravity_mps2 * (by_turn[0] + by_turn[2]) + noise.turn_mps2_2;
        P = corrected(q, by_turn, turn_variance);

        gains.turn_roll = by_turn[0];
        gains.turn_bank = gravity_mps2 * q.P13;
        gains.turn_offset = by_turn[3];
        gains.bank_growth_rad2 = by_turn[2] * by_turn[2] / turn_variance;
    }
    return gains;
}

}  // namespace rsi
