// Eight simulated hours without a turn: the covariance must stay symmetric, positive definite and bounded.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <string>

#include "rsi/estimation/robust_least_squares.hpp"
#include "tests/rsi/support/estimation_chain.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"
#include "tests/rsi/support/stages.hpp"

namespace covariance_endurance_test {
namespace {

constexpr int samples_in_eight_hours = 8 * 3600 * 100;

// Sylvester: the leading principal minors, each divided by the diagonal elements in it. All positive for a
// positive definite matrix; near zero when it is about to lose that.
double smallest_normalised_minor(const Eigen::Matrix3d& P) {
    const double second = P.topLeftCorner<2, 2>().determinant() / (P(0, 0) * P(1, 1));
    const double third = P.determinant() / (P(0, 0) * P(1, 1) * P(2, 2));
    return (P(0, 0) > 0.0) ? std::fmin(second, third) : P(0, 0);
}

struct Endurance {
    double smallest_minor{1.0};
    double smallest_variance{1.0e9};
    double largest_trace{0.0};
    double final_trace{0.0};
    rsi::RollCentreEstimate estimate{};
};

template <typename NextInputs>
Endurance endure(const rsi_parameters& parameters, NextInputs next_inputs) {
    rsi_test::EstimationChain chain(parameters);
    rsi_test::RobustLeastSquares estimator;
    estimator.init(parameters);
    Endurance result;
    for (int k = 0; k < samples_in_eight_hours; ++k) {
        rsi::Regression regression;
        EXPECT_TRUE(chain.step(next_inputs(), regression));
        estimator.update(regression);
        const Eigen::Matrix3d P = estimator.covariance().cast<double>();
        result.smallest_minor = std::fmin(result.smallest_minor, smallest_normalised_minor(P));
        result.smallest_variance = std::fmin(result.smallest_variance, P.diagonal().minCoeff());
        result.largest_trace = std::fmax(result.largest_trace, P.trace());
        result.final_trace = P.trace();
    }
    EXPECT_EQ(estimator.covariance(), estimator.covariance().transpose());  // to the last bit
    result.estimate = estimator.estimate();
    return result;
}

// Forgetting stops at the limit, so one last forgetting may carry the trace past it by 1/lambda.
void expect_healthy(const Endurance& result, const rsi_parameters& parameters, const char* what) {
    EXPECT_GT(result.smallest_minor, 0.0) << what;
    EXPECT_GT(result.smallest_variance, 0.0) << what;
    const double bound = static_cast<double>(parameters.covariance_limit) /
                         static_cast<double>(parameters.forgetting_factor) * (1.0 + 1.0e-6);
    EXPECT_LE(result.largest_trace, bound) << what;
    std::printf(
        "%s, lambda %g: smallest minor %.3e, smallest variance %.3e, largest trace %.3f, final %.3f, dh "
        "%.3f\n",
        what, static_cast<double>(parameters.forgetting_factor), result.smallest_minor,
        result.smallest_variance, result.largest_trace, result.final_trace,
        static_cast<double>(result.estimate.vertical_movement_m));
}

class CovarianceEndurance : public ::testing::TestWithParam<float> {
 protected:
    rsi_parameters parameters() const {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.forgetting_factor = GetParam();
        return parameters;
    }
};

TEST_P(CovarianceEndurance, EightHoursOfStraightRoadWithSensorNoise) {
    rsi_test::Noise noise(31U);
    const Endurance result = endure(parameters(), [&noise] {
        rsi_inputs inputs = rsi_test::at_rest();
        rsi_test::add_noise(noise, inputs);
        return inputs;
    });
    expect_healthy(result, parameters(), "noise");
}

TEST_P(CovarianceEndurance, EightHoursOfExactlyZeroInput) {
    const Endurance result = endure(parameters(), [] { return rsi_test::at_rest(); });
    expect_healthy(result, parameters(), "zero");
    EXPECT_EQ(result.estimate.vertical_movement_m, 0.0F);
}

// The hardest case for rounding: one parameter excited hard, the others not at all.
TEST_P(CovarianceEndurance, EightHoursOfOneSidedExcitation) {
    bool left = false;
    const Endurance result = endure(parameters(), [&left] {
        rsi_inputs inputs = rsi_test::at_rest();
        left = !left;
        inputs.lateral_specific_force_mps2 = left ? 6.0F : -6.0F;
        return inputs;
    });
    expect_healthy(result, parameters(), "one-sided");
}

INSTANTIATE_TEST_SUITE_P(ForgettingFactors, CovarianceEndurance, ::testing::Values(0.98F, 0.998F, 0.9999F),
                         [](const ::testing::TestParamInfo<float>& lambda) {
                             return "lambda" +
                                    std::to_string(static_cast<int>(lambda.param * 10000.0F + 0.5F));
                         });

}  // namespace
}  // namespace covariance_endurance_test
