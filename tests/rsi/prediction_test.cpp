// The prediction: a short look ahead at the roll motion.
#include "rsi/prediction/roll_predictor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rsi/support/index_reference.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace prediction_test {
namespace {

using rsi_test::gravity_mps2;

constexpr float horizon_s = 0.11F;  // of the calibrations
using rsi_test::ReferenceForce;
using rsi_test::ReferenceVehicle;

class Look {
 public:
    explicit Look(const rsi_parameters& parameters)
        : vehicle_{parameters},
          inertial_weight_{parameters.load_transfer_inertial_weight},
          response_{parameters},
          predictor_{parameters} {}
    rsi::Prediction ahead(const rsi::RollMotion& motion, const rsi::DemandedForce& demand = {},
                          const rsi::ForceTarget* target = nullptr, float forecast = 0.0F) const {
        return predictor_.evaluate(vehicle_, motion, load(motion), demand, response_, target, 0.0F, forecast);
    }
    float present(const rsi::RollMotion& motion) const { return load(motion).ratio; }

 private:
    rsi::TransferredLoad load(const rsi::RollMotion& motion) const {
        return rsi::transferred_load(vehicle_, inertial_weight_, motion);
    }

    rsi::Vehicle vehicle_;
    float inertial_weight_;
    rsi::LateralResponse response_;
    rsi::RollPredictor predictor_;
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
    return static_cast<double>(look.ahead(motion, demand).load_transfer_ratio);
}

TEST(Prediction, UnderAConstantForceItIsTheRollEquationsMotion) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.prediction_horizon_s = horizon_s;
    const ReferenceVehicle vehicle{parameters};
    const Look look{parameters};
    double largest_gain = 0.0;
    for (const double A : {-7.0, -3.0, 0.5, 4.0, 8.0}) {
        for (const double phi : {-0.05, 0.0, 0.03, 0.08}) {
            for (const double rate : {-0.4, 0.0, 0.2, 0.5}) {
                const double expected = rsi_test::predicted_load_transfer(
                    vehicle, ReferenceForce{A, 0.0}, gravity_mps2, phi, rate, static_cast<double>(horizon_s));
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
    const Look look{parameters};
    const rsi::RollMotion motion = motion_with(5.0, 0.04, 0.3, 30.0);
    EXPECT_EQ(look.ahead(motion).load_transfer_ratio, look.present(motion));
}

TEST(Prediction, TheForceGrowsNoFurtherThanTheSteeringAsks) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.prediction_horizon_s = horizon_s;
    const ReferenceVehicle vehicle{parameters};
    const Look look{parameters};
    const rsi::RollMotion motion = motion_with(4.0, 0.05, 0.1, 40.0);
    const double free = load_transfer_ahead(look, motion);
    const double asked_more = load_transfer_ahead(look, motion, {0.0F, 10.8F});
    const double asked_for_5 = load_transfer_ahead(look, motion, {0.0F, 5.0F});
    const double asked_less = load_transfer_ahead(look, motion, {0.0F, 2.0F});
    const double straight = load_transfer_ahead(look, motion, {0.0F, 0.0F});
    EXPECT_EQ(free, asked_more);  // 4 + 40 0.15 (1 - exp(-0.11 / 0.15)) = 7.1 stays below 10.8
    EXPECT_LT(asked_for_5, free - 0.1);
    const ReferenceForce force{4.0, 40.0, 0.15, true, 5.0};
    EXPECT_NEAR(asked_for_5,
                rsi_test::predicted_load_transfer(vehicle, force, gravity_mps2, 0.05, 0.1,
                                                  static_cast<double>(horizon_s)),
                0.035);  // the force meets its bound early in the step, which takes it for a straight rise
    EXPECT_LT(asked_less, asked_for_5);
    EXPECT_EQ(asked_less, straight);  // below where it is, the present force is the bound
    EXPECT_EQ(load_transfer_ahead(look, motion, {-9.0F, 0.0F}), straight);
}

TEST(Prediction, AFallingForceIsNotCarriedPastZeroUnlessTheSteeringAsksForTheOtherSide) {
    const Look look{rsi_test::large_suv()};
    const rsi::RollMotion motion = motion_with(1.0, 0.0, -0.3, -60.0);
    const double no_more = load_transfer_ahead(look, motion, {0.0F, 1.0F});
    const double other_side = load_transfer_ahead(look, motion, {-9.0F, 0.0F});
    EXPECT_LT(other_side, no_more - 0.2);
}

// A body that still stands in a left turn while the force swings over is about to fall to the left.
TEST(Prediction, ItsSideIsThatOfTheTransferToCome) {
    const Look look{rsi_test::large_suv()};
    const rsi::RollMotion motion = motion_with(0.5, 0.01, -0.5, -60.0);
    EXPECT_GT(look.present(motion), -0.3F);
    EXPECT_LT(look.ahead(motion).load_transfer_ratio, -0.5F);
}

TEST(Prediction, TheExtendedIndicatorReachesOneWhereTheLoadTransferDoes) {
    const Look look{rsi_test::large_suv()};
    for (int k = 0; k < 200; ++k) {
        rsi::RollMotion motion = motion_with(4.0 + 0.03 * k, 0.06, 0.3, 20.0);
        motion.roll_acceleration_radps2 = 20.0F;
        const rsi::Prediction prediction = look.ahead(motion);
        const float L = prediction.load_transfer_ratio;
        if (std::fabs(L - 1.0F) > 1.0e-4F) {
            EXPECT_EQ(prediction.rsi_extended > 1.0F, L > 1.0F) << L;
        }
    }
}

TEST(Prediction, EndsAtTwentyOnEitherSide) {
    const Look look{rsi_test::large_suv()};
    for (const double side : {1.0, -1.0}) {
        rsi::RollMotion motion = motion_with(side * 60.0, 0.0, 0.0, side * 1000.0);
        motion.road_normal_force_mps2 = 1.0F;
        EXPECT_EQ(static_cast<double>(look.present(motion)), side * 20.0);
        EXPECT_EQ(static_cast<double>(look.ahead(motion).load_transfer_ratio), side * 20.0);
    }
}

// 0.8 and, to the other side, nothing.
class ForecastInPrediction : public testing::Test {
 protected:
    rsi::Prediction with(float share, float limit, float forecast) const {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.prediction_horizon_s = 0.0F;
        parameters.forecast_share = share;
        parameters.forecast_limit = limit;
        return Look{parameters}.ahead(motion_, {}, nullptr, forecast);
    }

    rsi::RollMotion motion_ = motion_with(5.0, 0.04, 0.0);
    float predicted_ = with(0.0F, 0.4F, 9.0F).load_transfer_ratio;
};

TEST_F(ForecastInPrediction, MovesItByItsShare) {
    ASSERT_GT(predicted_, 0.3F);
    EXPECT_NEAR(with(0.5F, 0.4F, predicted_ + 0.1F).load_transfer_ratio, predicted_ + 0.05F, 1.0e-6F);
    EXPECT_NEAR(with(0.5F, 0.4F, predicted_ - 0.04F).load_transfer_ratio, predicted_ - 0.02F, 1.0e-6F);
    EXPECT_NEAR(with(1.0F, 0.4F, predicted_ + 0.1F).load_transfer_ratio, predicted_ + 0.1F, 1.0e-6F);
}

TEST_F(ForecastInPrediction, MovesItNoFurtherThanItsLimitAndDownByAQuarterOfThat) {
    EXPECT_NEAR(with(1.0F, 0.4F, 9.0F).load_transfer_ratio, 1.4F * predicted_, 1.0e-6F);
    EXPECT_NEAR(with(1.0F, 0.4F, -9.0F).load_transfer_ratio, 0.9F * predicted_, 1.0e-6F);
    EXPECT_EQ(with(1.0F, 0.0F, 9.0F).load_transfer_ratio, predicted_);
}

TEST_F(ForecastInPrediction, AloneWarnsOfNothing) {
    motion_ = motion_with(0.0, 0.0, 0.0);
    EXPECT_EQ(with(1.0F, 1.0F, 9.0F).load_transfer_ratio, 0.0F);
    EXPECT_EQ(with(1.0F, 1.0F, 9.0F).opposite_ratio, 0.0F);
}

TEST_F(ForecastInPrediction, CountsWithTheOtherSignForTheOtherSide) {
    motion_ = motion_with(0.5, 0.01, -0.5, -60.0);
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.prediction_horizon_s = horizon_s;
    const float alone = Look{parameters}.ahead(motion_).load_transfer_ratio;
    parameters.forecast_share = 0.5F;
    const float moved = Look{parameters}.ahead(motion_, {}, nullptr, alone - 0.1F).load_transfer_ratio;
    ASSERT_LT(alone, -0.3F);
    EXPECT_NEAR(moved, alone - 0.05F, 1.0e-6F);
}

// A look ahead by the lateral response alone: without the trend's horizon.
class LookAlongTheResponse {
 public:
    LookAlongTheResponse(double ahead_s, double margin_per_s)
        : parameters_{with(ahead_s, margin_per_s)}, look_{parameters_} {
        response_.init(parameters_);
    }
    rsi::Prediction operator()(const rsi::RollMotion& motion, double demanded_mps2) {
        rsi::DemandedForce demand;
        demand.force_mps2 = static_cast<float>(demanded_mps2);
        demand.is_known = true;
        EXPECT_TRUE(response_.update(motion, demand));
        return look_.ahead(motion, demand, &response_.target);
    }
    const rsi_parameters& parameters() const { return parameters_; }
    double present(const rsi::RollMotion& motion) const { return static_cast<double>(look_.present(motion)); }

 private:
    static rsi_parameters with(double ahead_s, double margin_per_s) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.prediction_horizon_s = 0.0F;
        parameters.lateral_response_frequency_radps = 9.0F;
        parameters.lateral_response_damping = 0.8F;
        parameters.response_horizon_s = static_cast<float>(ahead_s);
        parameters.response_margin_per_s = static_cast<float>(margin_per_s);
        return parameters;
    }

    rsi_parameters parameters_;
    Look look_;
    rsi_test::LateralResponse response_{};
};

TEST(ResponsePrediction, UnderAForceThatStaysItIsTheRollEquationsMotion) {
    LookAlongTheResponse look{0.3, 0.0};
    const ReferenceVehicle vehicle{look.parameters()};
    double largest_gain = 0.0;
    for (const double A : {2.0, 5.0, 6.0}) {
        const rsi::RollMotion motion = motion_with(A, 0.02, 0.1);
        // The largest of all steps: the reference with parts as long as a step and a half of the predictor.
        double expected = 0.0;
        for (int steps = 0; steps <= 15; ++steps) {
            expected =
                std::max(expected, rsi_test::predicted_load_transfer(vehicle, ReferenceForce{A}, gravity_mps2,
                                                                     0.02, 0.1, 0.02 * steps));
        }
        EXPECT_NEAR(static_cast<double>(look(motion, A).load_transfer_ratio), expected, 0.03) << A;
        largest_gain = std::max(largest_gain, expected - look.present(motion));
    }
    EXPECT_GT(largest_gain, 0.2);  // otherwise the comparison says nothing
}

TEST(ResponsePrediction, ASteeringThatAsksForMoreIsSeenBeforeTheForceMoves) {
    LookAlongTheResponse look{0.3, 0.0};
    const rsi::RollMotion motion = motion_with(2.0, 0.03, 0.0);
    const double asked_more = static_cast<double>(look(motion, 8.0).load_transfer_ratio);
    EXPECT_GT(asked_more, static_cast<double>(look(motion, 2.0).load_transfer_ratio) + 0.3);
    LookAlongTheResponse nearer{0.1, 0.0};
    EXPECT_LT(static_cast<double>(nearer(motion, 8.0).load_transfer_ratio), asked_more - 0.2);
}

TEST(ResponsePrediction, KnowsBothSidesOfASwing) {
    LookAlongTheResponse look{0.5, 0.0};
    const rsi::RollMotion motion = motion_with(6.0, 0.08, 0.0, -30.0);
    const rsi::Prediction prediction = look(motion, -8.0);
    EXPECT_NEAR(prediction.opposite_ratio, look.present(motion), 0.05);
    EXPECT_LT(prediction.load_transfer_ratio, -static_cast<float>(look.present(motion)));
    rsi::RollMotion mirrored = motion_with(-6.0, -0.08, 0.0, 30.0);
    const rsi::Prediction other = look(mirrored, 8.0);
    EXPECT_EQ(other.load_transfer_ratio, -prediction.load_transfer_ratio);
    EXPECT_EQ(other.opposite_ratio, prediction.opposite_ratio);
}

// Wheels that are up come down before those of the other side lift: until then there is no risk on that side.
TEST(ResponsePrediction, HasNoOtherSideWhileWheelsAreUp) {
    LookAlongTheResponse look{0.5, 0.0};
    for (const double side : {1.0, -1.0}) {
        const rsi::RollMotion nearly = motion_with(side * 7.6, side * 0.115, 0.0, side * -45.0);
        ASSERT_LT(std::fabs(look.present(nearly)), 1.0);
        ASSERT_GT(std::fabs(look.present(nearly)), 0.91);
        EXPECT_LT(side * static_cast<double>(look(nearly, side * -8.0).load_transfer_ratio), -0.5);
        const rsi::RollMotion up = motion_with(side * 9.0, side * 0.12, 0.0, side * -45.0);
        ASSERT_GT(side * look.present(up), 1.0);
        const rsi::Prediction prediction = look(up, side * -8.0);
        EXPECT_GT(side * static_cast<double>(prediction.load_transfer_ratio), 1.0);
        EXPECT_EQ(prediction.opposite_ratio, 0.0F);
    }
}

TEST(Prediction, InASteadyTurnTheOtherSideHasNoRisk) {
    const Look look{rsi_test::large_suv()};
    for (const double side : {1.0, -1.0}) {
        const rsi::Prediction prediction = look.ahead(motion_with(side * 4.0, side * 0.06, 0.0));
        EXPECT_GT(side * static_cast<double>(prediction.load_transfer_ratio), 0.3);
        EXPECT_EQ(prediction.opposite_ratio, 0.0F);
    }
}

TEST(ResponsePrediction, TheHorizonIsRoundedToSteps) {
    const rsi::RollMotion motion = motion_with(2.0, 0.03, 0.0);
    const auto level = [&](double ahead_s) {
        return LookAlongTheResponse{ahead_s, 0.0}(motion, 8.0).load_transfer_ratio;
    };
    ASSERT_GT(level(0.04), level(0.0));
    EXPECT_EQ(level(0.0205), level(0.04));
    EXPECT_EQ(level(0.0195), level(0.0));
    EXPECT_EQ(level(0.0605), level(0.08));
    EXPECT_EQ(level(0.0595), level(0.04));
}

// Anything further ahead than a tenth of a second counts less by the margin; nearer values and the present
// count in full.
TEST(ResponsePrediction, TheMarginGrowsWithTheTimeAhead) {
    const rsi::RollMotion motion = motion_with(2.0, 0.03, 0.0);
    const auto level = [&](double ahead_s, double margin_per_s) {
        return static_cast<double>(
            LookAlongTheResponse{ahead_s, margin_per_s}(motion, 8.0).load_transfer_ratio);
    };
    EXPECT_EQ(level(0.08, 0.0), level(0.08, 1.0));
    EXPECT_NEAR(level(0.12, 0.0) - level(0.12, 1.0), 0.02, 1e-4);
    EXPECT_NEAR(level(0.28, 0.0) - level(0.28, 1.0), 0.18, 1e-4);
    const double present = level(0.0, 0.0);
    EXPECT_EQ(level(0.3, 2.0) >= present, true);
    EXPECT_EQ(LookAlongTheResponse(0.0, 0.0).present(motion), present);
}

class DemandOf {
 public:
    explicit DemandOf(const rsi_parameters& parameters) : stage_{parameters} {}
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
    rsi::SteeringDemand stage_;
};

TEST(SteeringDemand, IsTheSteadyTurnsAcceleration) {
    const DemandOf demand{rsi_test::large_suv()};
    // 20^2 (1/20) / (2.95 + 0.003 20^2) = 4.8193
    EXPECT_NEAR(static_cast<double>(demand(20.0F, 1.0F).most_mps2), 4.8193, 1e-3);
    EXPECT_NEAR(static_cast<double>(demand(20.0F, -1.0F).least_mps2), -4.8193, 1e-3);
    EXPECT_NEAR(static_cast<double>(demand(20.0F, 1.0F, 0.8F).most_mps2), 5.6193, 1e-3);
    EXPECT_EQ(demand(20.0F, 1.0F).least_mps2, 0.0F);
    EXPECT_EQ(demand(20.0F, -1.0F).most_mps2, 0.0F);
}

TEST(SteeringDemand, IsBoundedByTheTyresAndByNothingElse) {
    rsi_parameters parameters = rsi_test::large_suv();
    EXPECT_EQ(DemandOf{parameters}(40.0F, 8.0F).most_mps2, 10.8F);
    parameters.understeer_gradient_s2pm = -0.01F;  // critical speed 17 m/s
    EXPECT_EQ(DemandOf{parameters}(30.0F, 3.0F).most_mps2, 10.8F);
    EXPECT_EQ(DemandOf{parameters}(30.0F, -3.0F).least_mps2, -10.8F);
}

TEST(SteeringDemand, ItselfIsBoundedBeyondAllTyres) {
    const DemandOf demand{rsi_test::large_suv()};
    EXPECT_NEAR(static_cast<double>(demand(20.0F, -1.0F).force_mps2), -4.8193, 1e-3);
    EXPECT_NEAR(static_cast<double>(demand(20.0F, 10.0F).force_mps2), 48.193, 1e-2);
    EXPECT_EQ(demand(20.0F, 25.0F).force_mps2, 60.0F);
    EXPECT_EQ(demand(20.0F, -25.0F).force_mps2, -60.0F);
}

bool unbounded(const rsi::DemandedForce& demand) {
    return (demand.least_mps2 <= -60.0F) && (demand.most_mps2 >= 60.0F);
}

TEST(SteeringDemand, IsUnknownWithoutSpeedOrSteering) {
    const DemandOf demand{rsi_test::large_suv()};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(unbounded(demand(nan, 1.0F)));
    EXPECT_TRUE(unbounded(demand(20.0F, nan)));
    EXPECT_TRUE(unbounded(demand(20.0F, 31.0F)));
    EXPECT_TRUE(unbounded(demand(200.0F, 1.0F)));
    for (const float sign : {1.0F, -1.0F}) {
        EXPECT_FALSE(unbounded(demand(sign * 150.0F, 0.01F)));
        EXPECT_TRUE(unbounded(demand(sign * 150.1F, 0.01F)));
        EXPECT_FALSE(unbounded(demand(20.0F, sign * 30.0F)));
        EXPECT_TRUE(unbounded(demand(20.0F, sign * 30.1F)));
    }
}

TEST(SteeringDemand, PastTheCriticalSpeedATenthOfTheWheelbaseRemains) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.understeer_gradient_s2pm = -0.01F;
    // 30^2 0.05 / (0.1 20 2.95) = 7.6271
    EXPECT_NEAR(static_cast<double>(DemandOf{parameters}(30.0F, 0.05F).most_mps2), 7.6271, 1e-3);
}

}  // namespace
}  // namespace prediction_test
