// Least squares floor: (8) to (11) with as few operations as they can do with, nothing guarded and nothing
// checked; what the firmware's update is measured against.
#pragma once

#include <array>

namespace budgets {

// Constants from sample to sample are prepared: the scales are divided before, forgetting holds.
template <typename Scalar>
struct LeastSquaresState {
    std::array<Scalar, 3> theta;  // scaled
    std::array<Scalar, 6> P;      // 00 01 02 11 12 22
    Scalar disturbance;
};

template <typename Scalar>
struct LeastSquaresConstants {
    std::array<Scalar, 3> psi_scale;
    Scalar output_scale;
    Scalar growth;  // 1 / lambda
    Scalar lambda;
    Scalar one_plus_lambda;
    Scalar disturbance_weight;
};

template <typename Scalar>
void update(LeastSquaresState<Scalar>& state, const LeastSquaresConstants<Scalar>& constant,
            const std::array<Scalar, 3>& psi_unscaled, Scalar output) {
    auto& [theta, P, disturbance] = state;
    const Scalar x = psi_unscaled[0] * constant.psi_scale[0];
    const Scalar y = psi_unscaled[1] * constant.psi_scale[1];
    const Scalar z = psi_unscaled[2] * constant.psi_scale[2];
    const Scalar g0 = P[0] * x + P[1] * y + P[2] * z;
    const Scalar g1 = P[1] * x + P[3] * y + P[4] * z;
    const Scalar g2 = P[2] * x + P[4] * y + P[5] * z;
    const Scalar s = x * g0 + y * g1 + z * g2;
    const Scalar innovation =
        output * constant.output_scale - x * theta[0] - y * theta[1] - z * theta[2] - disturbance;
    // lambda (1 + s) + s = lambda + (1 + lambda) s; the gain of theta and that of P share the one division.
    const Scalar reciprocal = constant.growth / (constant.lambda + constant.one_plus_lambda * s);
    const Scalar gain = constant.lambda * reciprocal * innovation;
    theta[0] = theta[0] + g0 * gain;
    theta[1] = theta[1] + g1 * gain;
    theta[2] = theta[2] + g2 * gain;
    const Scalar u0 = g0 * reciprocal;
    const Scalar u1 = g1 * reciprocal;
    const Scalar u2 = g2 * reciprocal;
    P[0] = P[0] * constant.growth - u0 * g0;
    P[1] = P[1] * constant.growth - u0 * g1;
    P[2] = P[2] * constant.growth - u0 * g2;
    P[3] = P[3] * constant.growth - u1 * g1;
    P[4] = P[4] * constant.growth - u1 * g2;
    P[5] = P[5] * constant.growth - u2 * g2;
    disturbance = disturbance + constant.disturbance_weight * innovation;
}

// The constants and the first state that the parameters give; `scalar` makes one of a float.
template <typename Parameters, typename Make>
auto begin_least_squares(const Parameters& p, float disturbance_weight, Make scalar) {
    using Scalar = decltype(scalar(0.0F));
    const float lambda = p.forgetting_factor;
    const float scale = p.regression_scale_nm;
    struct {
        LeastSquaresState<Scalar> state;
        LeastSquaresConstants<Scalar> constants;
    } begun{{{scalar(0.0F), scalar(0.0F), scalar(0.0F)},
             {scalar(1.0F), scalar(0.0F), scalar(0.0F), scalar(1.0F), scalar(0.0F), scalar(1.0F)},
             scalar(0.0F)},
            {{scalar(p.initial_roll_centre_deviation_m / scale),
              scalar(p.initial_stiffness_deviation_nmprad / scale),
              scalar(p.initial_damping_deviation_nmsprad / scale)},
             scalar(1.0F / scale),
             scalar(1.0F / lambda),
             scalar(lambda),
             scalar(1.0F + lambda),
             scalar(disturbance_weight)}};
    return begun;
}

}  // namespace budgets
