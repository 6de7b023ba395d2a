// Robust least squares with disturbance observer against (8) to (11) in double, and on problems whose answer
// is known.
#include "rsi/estimation/robust_least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/rsi/support/estimation_chain.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"
#include "tests/rsi/support/reference_least_squares.hpp"
#include "tests/rsi/support/stages.hpp"

namespace robust_least_squares_test {
namespace {

using rsi_test::Deviation;
using rsi_test::EstimationChain;
using rsi_test::Noise;
using rsi_test::RecordedLikeDrive;
using rsi_test::ReferenceLeastSquares;

rsi_test::RobustLeastSquares estimator_of(const rsi_parameters& parameters) {
    rsi_test::RobustLeastSquares estimator;
    estimator.init(parameters);
    return estimator;
}

double wide(float value) {
    return static_cast<double>(value);
}

// Largest differences between the component's float and the reference's double.
struct Difference {
    double vertical_m{0.0};
    double stiffness{0.0};  // in units of its initial deviation
    double damping{0.0};
    double disturbance_nm{0.0};
};

Difference largest_difference_over_drive(const rsi_parameters& parameters, const Deviation& truth,
                                         int samples) {
    rsi_test::RobustLeastSquares estimator = estimator_of(parameters);
    ReferenceLeastSquares reference(parameters);
    EstimationChain chain(parameters);
    RecordedLikeDrive drive(parameters, truth, 3U);
    Difference largest;
    for (int k = 0; k < samples; ++k) {
        rsi::Regression regression;
        EXPECT_TRUE(chain.step(drive.next(), regression));
        estimator.update(regression);
        reference.update(wide(regression.output_nm), regression.psi.cast<double>());
        const rsi::RollCentreEstimate estimate = estimator.estimate();
        const auto grow = [](double& to, double difference) { to = std::fmax(to, std::fabs(difference)); };
        grow(largest.vertical_m, wide(estimate.vertical_movement_m) - reference.theta().x());
        grow(largest.stiffness, (wide(estimate.stiffness_deviation_nmprad) - reference.theta().y()) /
                                    wide(parameters.initial_stiffness_deviation_nmprad));
        grow(largest.damping, (wide(estimate.damping_deviation_nmsprad) - reference.theta().z()) /
                                  wide(parameters.initial_damping_deviation_nmsprad));
        grow(largest.disturbance_nm, wide(estimate.disturbance_nm) - reference.disturbance_nm());
    }
    return largest;
}

// Ten minutes of lively driving. Float carries 24 bits; the recursion's gain mixes P's error (a few 1e-6 of
// P(0)) into theta, so 1e-4 of an initial deviation is far above rounding and far below any effect on the
// indicator. Without forgetting (lambda 1) rounding errors are not forgotten either and add up: ten times as
// much.
TEST(RobustLeastSquares, AgreesWithTheDoubleReferenceOnADrive) {
    for (const float lambda : {0.98F, 0.99F, 0.999F, 1.0F}) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.forgetting_factor = lambda;
        parameters.covariance_limit = 1.0e6F;  // the reference knows no limit
        const Difference largest =
            largest_difference_over_drive(parameters, Deviation{0.05, -5.0e3, 600.0}, 60000);
        const double allowed = (lambda < 1.0F) ? 1.0e-4 : 3.0e-3;
        EXPECT_LT(largest.vertical_m, allowed * 0.1) << lambda;
        EXPECT_LT(largest.stiffness, allowed) << lambda;
        EXPECT_LT(largest.damping, allowed) << lambda;
        EXPECT_LT(largest.disturbance_nm, allowed * wide(parameters.regression_scale_nm)) << lambda;
    }
}

// The same over fifteen seconds.
TEST(RobustLeastSquares, AgreesWithTheDoubleReferenceFromItsStart) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.forgetting_factor = 0.99F;
    parameters.covariance_limit = 1.0e6F;
    const Difference largest =
        largest_difference_over_drive(parameters, Deviation{0.05, -5.0e3, 600.0}, 1500);
    EXPECT_LT(largest.vertical_m, 1.0e-5);
    EXPECT_LT(largest.stiffness, 1.0e-4);
    EXPECT_LT(largest.damping, 1.0e-4);
    EXPECT_LT(largest.disturbance_nm, 1.0e-4 * wide(parameters.regression_scale_nm));
}

TEST(RobustLeastSquares, TheCovarianceAgreesWithTheDoubleReference) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.covariance_limit = 1.0e6F;
    rsi_test::RobustLeastSquares estimator = estimator_of(parameters);
    ReferenceLeastSquares reference(parameters);
    EstimationChain chain(parameters);
    RecordedLikeDrive drive(parameters, Deviation{}, 5U);
    for (int k = 0; k < 6000; ++k) {
        rsi::Regression regression;
        ASSERT_TRUE(chain.step(drive.next(), regression));
        estimator.update(regression);
        reference.update(wide(regression.output_nm), regression.psi.cast<double>());
    }
    const Eigen::Vector3d unit = Eigen::Vector3d(0.1, 1.0e4, 1.0e3) / 450.0;
    const rsi::Matrix3& P = estimator.covariance();
    const Eigen::Matrix3d expected = reference.covariance().cwiseQuotient(unit * unit.transpose());
    const double tolerance = 1.0e-4 * expected.trace();
    EXPECT_NEAR(wide(P(0, 0)), expected(0, 0), tolerance);
    EXPECT_NEAR(wide(P(0, 1)), expected(0, 1), tolerance);
    EXPECT_NEAR(wide(P(0, 2)), expected(0, 2), tolerance);
    EXPECT_NEAR(wide(P(1, 1)), expected(1, 1), tolerance);
    EXPECT_NEAR(wide(P(1, 2)), expected(1, 2), tolerance);
    EXPECT_NEAR(wide(P(2, 2)), expected(2, 2), tolerance);
}

// Regressors that excite all three parameters independently, each about as strongly as P(0) expects.
rsi::Regression exciting(Noise& noise, const Deviation& truth, double disturbance_nm) {
    rsi::Regression regression;
    regression.psi << static_cast<float>(noise(4500.0)), static_cast<float>(noise(0.045)),
        static_cast<float>(noise(0.45));
    regression.output_nm = static_cast<float>(
        truth.vertical_m * wide(regression.psi.x()) + truth.stiffness_nmprad * wide(regression.psi.y()) +
        truth.damping_nmsprad * wide(regression.psi.z()) + disturbance_nm);
    return regression;
}

TEST(RobustLeastSquares, FindsTheParametersWhenEachIsExcited) {
    const Deviation truth{0.07, -8.0e3, 700.0};
    for (const float cutoff_hz : {0.0F, 0.1F}) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.forgetting_factor = 0.98F;
        parameters.disturbance_cutoff_hz = cutoff_hz;
        rsi_test::RobustLeastSquares estimator = estimator_of(parameters);
        Noise noise(17U);
        for (int k = 0; k < 5000; ++k) {
            estimator.update(exciting(noise, truth, 0.0));
        }
        EXPECT_NEAR(wide(estimator.estimate().vertical_movement_m), truth.vertical_m, 1.0e-5);
        EXPECT_NEAR(wide(estimator.estimate().stiffness_deviation_nmprad), truth.stiffness_nmprad, 1.0);
        EXPECT_NEAR(wide(estimator.estimate().damping_deviation_nmsprad), truth.damping_nmsprad, 0.1);
        EXPECT_NEAR(wide(estimator.estimate().disturbance_nm), 0.0, 0.1);
    }
}

TEST(RobustLeastSquares, TheDisturbanceObserverTakesAConstantDisturbanceOutOfTheParameters) {
    const Deviation truth{0.07, -8.0e3, 700.0};
    rsi_parameters parameters = rsi_test::large_suv();
    rsi_test::RobustLeastSquares estimator = estimator_of(parameters);
    Noise noise(19U);
    for (int k = 0; k < 20000; ++k) {
        estimator.update(exciting(noise, truth, 300.0));
    }
    EXPECT_NEAR(wide(estimator.estimate().disturbance_nm), 300.0, 1.0);
    EXPECT_NEAR(wide(estimator.estimate().vertical_movement_m), truth.vertical_m, 1.0e-3);
    EXPECT_NEAR(wide(estimator.estimate().stiffness_deviation_nmprad), truth.stiffness_nmprad, 100.0);
    EXPECT_NEAR(wide(estimator.estimate().damping_deviation_nmsprad), truth.damping_nmsprad, 10.0);
}

// (11) alone: with nothing to attribute Y to, d is the first-order low-pass of Y.
TEST(RobustLeastSquares, TheDisturbanceFollowsItsLowPassWhenNothingElseExplainsTheOutput) {
    for (const float cutoff_hz : {0.0F, 0.1F, 1.0F, 10.0F}) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.disturbance_cutoff_hz = cutoff_hz;
        rsi_test::RobustLeastSquares estimator = estimator_of(parameters);
        for (int k = 1; k <= 300; ++k) {
            rsi::Regression regression;
            regression.output_nm = 500.0F;
            regression.psi.setZero();
            estimator.update(regression);
            const double expected =
                500.0 * (1.0 - std::exp(-2.0 * rsi_test::pi * wide(cutoff_hz) * 0.01 * k));
            ASSERT_NEAR(wide(estimator.estimate().disturbance_nm), expected, 0.01);
        }
        EXPECT_EQ(estimator.estimate().vertical_movement_m, 0.0F);
    }
}

TEST(RobustLeastSquares, MirroredSamplesGiveTheSameParametersAndTheOppositeDisturbance) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_test::RobustLeastSquares left = estimator_of(parameters);
    rsi_test::RobustLeastSquares right = estimator_of(parameters);
    Noise noise(23U);
    for (int k = 0; k < 2000; ++k) {
        rsi::Regression regression = exciting(noise, Deviation{0.05, 1.0e3, -200.0}, 50.0);
        left.update(regression);
        regression.output_nm = -regression.output_nm;
        regression.psi = -regression.psi;
        right.update(regression);
    }
    EXPECT_EQ(left.estimate().vertical_movement_m, right.estimate().vertical_movement_m);
    EXPECT_EQ(left.estimate().stiffness_deviation_nmprad, right.estimate().stiffness_deviation_nmprad);
    EXPECT_EQ(left.estimate().damping_deviation_nmsprad, right.estimate().damping_deviation_nmsprad);
    EXPECT_EQ(left.estimate().disturbance_nm, -right.estimate().disturbance_nm);
}

TEST(RobustLeastSquares, ASampleThatCannotBeRepresentedResetsTheEstimator) {
    rsi_test::RobustLeastSquares estimator = estimator_of(rsi_test::large_suv());
    Noise noise(29U);
    for (int k = 0; k < 100; ++k) {
        estimator.update(exciting(noise, Deviation{0.05, 0.0, 0.0}, 0.0));
    }
    ASSERT_NE(estimator.estimate().vertical_movement_m, 0.0F);
    rsi::Regression regression = exciting(noise, Deviation{}, 0.0);
    regression.output_nm = std::numeric_limits<float>::quiet_NaN();
    estimator.update(regression);
    EXPECT_EQ(estimator.estimate().vertical_movement_m, 0.0F);
    EXPECT_EQ(estimator.covariance()(0, 0), 1.0F);
}

// An element without excitation forgets nothing once the trace is above its limit, whichever element it is.
TEST(RobustLeastSquares, AResetForgetsParametersCovarianceAndDisturbance) {
    rsi_test::RobustLeastSquares estimator = estimator_of(rsi_test::large_suv());
    rsi::Regression regression;
    regression.psi = Eigen::Vector3f{4000.0F, 0.05F, 0.2F};
    regression.output_nm = 300.0F;
    for (int k = 0; k < 50; ++k) {
        estimator.update(regression);
    }
    ASSERT_NE(estimator.estimate().vertical_movement_m, 0.0F);
    ASSERT_NE(estimator.estimate().disturbance_nm, 0.0F);
    estimator.reset();
    const rsi::RollCentreEstimate estimate = estimator.estimate();
    EXPECT_EQ(estimate.vertical_movement_m, 0.0F);
    EXPECT_EQ(estimate.stiffness_deviation_nmprad, 0.0F);
    EXPECT_EQ(estimate.damping_deviation_nmsprad, 0.0F);
    EXPECT_EQ(estimate.disturbance_nm, 0.0F);
    EXPECT_EQ(estimator.covariance()(0, 0), 1.0F);
    EXPECT_EQ(estimator.covariance()(0, 1), 0.0F);
}

TEST(RobustLeastSquares, EachElementOfTheCovarianceCountsInItsLimit) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.forgetting_factor = 0.95F;
    parameters.covariance_limit = 5.0F;
    for (int excited = 0; excited < 3; ++excited) {
        rsi_test::RobustLeastSquares estimator = estimator_of(parameters);
        const float scale[3] = {parameters.initial_roll_centre_deviation_m,
                                parameters.initial_stiffness_deviation_nmprad,
                                parameters.initial_damping_deviation_nmsprad};
        rsi::Regression regression{};
        regression.psi.setZero();
        regression.psi[excited] = parameters.regression_scale_nm / scale[excited];
        double trace = 0.0;
        for (int k = 0; k < 500; ++k) {
            estimator.update(regression);
            const rsi::Matrix3& P = estimator.covariance();
            trace = wide(P(0, 0)) + wide(P(1, 1)) + wide(P(2, 2));
            ASSERT_LE(trace, 5.0 / 0.95 + 1.0e-4) << excited << ' ' << k;
        }
        EXPECT_GT(trace, 4.5) << excited;
    }
}

TEST(RobustLeastSquares, AboveItsLimitWhatIsNotExcitedStaysAsItIs) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.forgetting_factor = 0.95F;
    parameters.covariance_limit = 5.0F;
    rsi_test::RobustLeastSquares estimator = estimator_of(parameters);
    rsi::Regression regression{};
    regression.psi << parameters.regression_scale_nm / parameters.initial_roll_centre_deviation_m, 0.0F, 0.0F;
    while (estimator.covariance().trace() <= parameters.covariance_limit) {
        estimator.update(regression);
    }
    const float before = estimator.covariance()(1, 1);
    estimator.update(regression);
    EXPECT_EQ(estimator.covariance()(1, 1), before);
}

TEST(RobustLeastSquares, StartsWithTheUnitMatrix) {
    const rsi::Matrix3 P = estimator_of(rsi_test::large_suv()).covariance();
    EXPECT_EQ(P(0, 0), 1.0F);
    EXPECT_EQ(P(1, 1), 1.0F);
    EXPECT_EQ(P(2, 2), 1.0F);
    EXPECT_EQ(P(0, 1), 0.0F);
    EXPECT_EQ(P(0, 2), 0.0F);
    EXPECT_EQ(P(1, 2), 0.0F);
}

// (10) with lambda = 1, in the one direction that is excited.
TEST(RobustLeastSquares, AboveItsLimitWhatIsExcitedIsLearntWithoutForgetting) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.forgetting_factor = 0.95F;
    parameters.covariance_limit = 5.0F;
    rsi_test::RobustLeastSquares estimator = estimator_of(parameters);
    rsi::Regression regression{};
    regression.psi << parameters.regression_scale_nm / parameters.initial_roll_centre_deviation_m, 0.0F, 0.0F;
    while (estimator.covariance().trace() <= parameters.covariance_limit) {
        estimator.update(regression);
    }
    const double before = wide(estimator.covariance()(0, 0));
    estimator.update(regression);
    EXPECT_NEAR(wide(estimator.covariance()(0, 0)), before - before * before / (1.0 + 2.0 * before),
                1.0e-5 * before);
}

}  // namespace
}  // namespace robust_least_squares_test
