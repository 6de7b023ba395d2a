// The prediction: a short look ahead at the roll motion.
#include "rsi/indicator/prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/support/index_reference.hpp"
#include "tests/unit/support/nominal.hpp"

namespace {

using rsi_test::gravity_mps2;
using rsi_test::ReferenceForce;
using rsi_test::ReferenceVehicle;

class Look {
 public:
    explicit Look(const rsi_parameters& parameters) {
        predictor_.init(parameters);
        load_transfer_.init(parameters);
        extended_.init(parameters);
    }
    rsi::Prediction ahead(const rsi::RollMotion& motion, const rsi::DemandedForce& demand = {}) const {
        return predictor_.evaluate(motion, demand, load_transfer_, extended_, 0.0F);
    }

 private:
    rsi::RollPredictor predictor_{};
    rsi::LoadTransfer load_transfer_{};
    rsi::ExtendedIndicator extended_{};
};

rsi::RollMotion motion_with(double A, double phi, double rate, double force_rate = 0.0) {
    rsi::RollMotion motion;
    motion.road_parallel_force_mps2 = static_cast<float>(A);
    motion.road_normal_force_mps2 = static_cast<float>(gravity_mps2);
    motion.roll_angle_rad = static_cast<float>(phi);
    motion.roll_rate_radps = static_cast<float>(rate);
    motion.road_parallel_force_rate_mps3 = static_cast<float>(force_rate);
    return motion;
}

double load_transfer_ahead(const Look& look, const rsi::RollMotion& motion,
                           const rsi::DemandedForce& demand = {}) {
    return static_cast<double>(look.ahead(motion, demand).worst.load_transfer_ratio);
}

TEST(Prediction, UnderAConstantForceItIsTheRollEquationsMotion) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const ReferenceVehicle vehicle{parameters};
    const Look look{parameters};
    double largest_gain = 0.0;
    for (const double A : {-7.0, -3.0, 0.5, 4.0, 8.0}) {
        for (const double phi : {-0.05, 0.0, 0.03, 0.08}) {
            for (const double rate : {-0.4, 0.0, 0.2, 0.5}) {
                const double expected = rsi_test::predicted_load_transfer(vehicle, ReferenceForce{A, 0.0},
                                                                          gravity_mps2, phi, rate, 0.2);
                const rsi::RollMotion motion = motion_with(A, phi, rate);
                EXPECT_NEAR(std::fabs(load_transfer_ahead(look, motion)), std::fabs(expected),
                            rsi_test::prediction_tolerance(expected))
                    << A << ' ' << phi << ' ' << rate;
                largest_gain = std::max(largest_gain, std::fabs(expected) - std::fabs(vehicle.load_transfer(
                                                                                A, gravity_mps2, phi, rate)));
            }
        }
    }
    EXPECT_GT(largest_gain, 0.3);  // otherwise the comparison says nothing
}

TEST(Prediction, WithoutAHorizonItIsThePresent) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.prediction_horizon_s = 0.0F;
    const rsi::Prediction prediction = Look{parameters}.ahead(motion_with(5.0, 0.04, 0.3, 30.0));
    EXPECT_EQ(prediction.worst.load_transfer_ratio, prediction.present.load_transfer_ratio);
}

TEST(Prediction, TheForceGrowsNoFurtherThanTheSteeringAsks) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const ReferenceVehicle vehicle{parameters};
    const Look look{parameters};
    const rsi::RollMotion motion = motion_with(4.0, 0.05, 0.1, 40.0);
    const double free = load_transfer_ahead(look, motion);
    const double asked_more = load_transfer_ahead(look, motion, {10.8F, true});
    const double asked_for_5 = load_transfer_ahead(look, motion, {5.0F, true});
    const double asked_less = load_transfer_ahead(look, motion, {2.0F, true});
    const double straight = load_transfer_ahead(look, motion, {0.0F, true});
    EXPECT_EQ(free, asked_more);  // 4 + 40 0.15 = 10 stays below 10.8
    EXPECT_LT(asked_for_5, free - 0.3);
    const ReferenceForce force{4.0, 40.0, 0.15, true, 5.0};
    EXPECT_NEAR(asked_for_5, rsi_test::predicted_load_transfer(vehicle, force, gravity_mps2, 0.05, 0.1, 0.2),
                0.02);  // the force meets its bound within a step
    EXPECT_LT(asked_less, asked_for_5);
    EXPECT_EQ(asked_less, straight);  // below where it is, the present force is the bound
    EXPECT_EQ(load_transfer_ahead(look, motion, {-9.0F, true}), straight);
}

TEST(Prediction, AFallingForceIsNotCarriedPastZeroUnlessTheSteeringAsksForTheOtherSide) {
    const Look look{rsi_test::large_suv()};
    const rsi::RollMotion motion = motion_with(1.0, 0.0, -0.3, -60.0);
    const double no_more = load_transfer_ahead(look, motion, {1.0F, true});
    const double other_side = load_transfer_ahead(look, motion, {-9.0F, true});
    EXPECT_LT(other_side, no_more - 0.2);
}

// A body that still stands in a left turn while the force swings over is about to fall to the left.
TEST(Prediction, ItsSideIsThatOfTheTransferToCome) {
    const rsi::Prediction prediction = Look{rsi_test::large_suv()}.ahead(motion_with(0.5, 0.01, -0.5, -60.0));
    EXPECT_GT(prediction.present.load_transfer_ratio, -0.3F);
    EXPECT_LT(prediction.worst.load_transfer_ratio, -0.5F);
}

TEST(Prediction, TheExtendedIndicatorReachesOneWhereTheLoadTransferDoes) {
    const Look look{rsi_test::large_suv()};
    for (int k = 0; k < 200; ++k) {
        // The roll acceleration is large, so that the present extended indicator stays small.
        rsi::RollMotion motion = motion_with(4.0 + 0.03 * k, 0.06, 0.3, 20.0);
        motion.roll_acceleration_radps2 = 20.0F;
        const rsi::Prediction prediction = look.ahead(motion);
        const float L = prediction.worst.load_transfer_ratio;
        if (std::fabs(L - 1.0F) > 1.0e-4F) {
            EXPECT_EQ(prediction.worst.rsi_extended > 1.0F, L > 1.0F) << L;
        }
    }
}

class DemandOf {
 public:
    explicit DemandOf(const rsi_parameters& parameters) { stage_.init(parameters); }
    rsi::DemandedForce operator()(float speed_mps, float angle_rad, float bank_share_mps2 = 0.0F) const {
        rsi_inputs inputs{};
        inputs.speed_mps = speed_mps;
        inputs.steering_wheel_angle_rad = angle_rad;
        rsi::Measurement measured;
        measured.road_parallel_force_mps2 = 3.0F + bank_share_mps2;
        measured.lateral_acceleration_mps2 = 3.0F;
        return stage_.evaluate(inputs, measured);
    }

 private:
    rsi::SteeringDemand stage_{};
};

TEST(SteeringDemand, IsTheSteadyTurnsAcceleration) {
    const DemandOf demand{rsi_test::large_suv()};
    // 20^2 (1/20) / (2.95 + 0.003 20^2) = 4.8193
    EXPECT_NEAR(static_cast<double>(demand(20.0F, 1.0F).parallel_mps2), 4.8193, 1e-3);
    EXPECT_NEAR(static_cast<double>(demand(20.0F, -1.0F).parallel_mps2), -4.8193, 1e-3);
    EXPECT_NEAR(static_cast<double>(demand(20.0F, 1.0F, 0.8F).parallel_mps2), 5.6193, 1e-3);
    EXPECT_TRUE(demand(20.0F, 1.0F).known);
}

TEST(SteeringDemand, IsBoundedByTheTyresAndByNothingElse) {
    rsi_parameters parameters = rsi_test::large_suv();
    EXPECT_EQ(DemandOf{parameters}(40.0F, 8.0F).parallel_mps2, 10.8F);
    parameters.understeer_gradient_s2pm = -0.01F;  // critical speed 17 m/s
    EXPECT_EQ(DemandOf{parameters}(30.0F, 3.0F).parallel_mps2, 10.8F);
    EXPECT_EQ(DemandOf{parameters}(30.0F, -3.0F).parallel_mps2, -10.8F);
}

TEST(SteeringDemand, IsUnknownWithoutSpeedOrSteering) {
    const DemandOf demand{rsi_test::large_suv()};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(demand(nan, 1.0F).known);
    EXPECT_FALSE(demand(20.0F, nan).known);
    EXPECT_FALSE(demand(20.0F, 31.0F).known);
    EXPECT_FALSE(demand(200.0F, 1.0F).known);
}

}  // namespace
