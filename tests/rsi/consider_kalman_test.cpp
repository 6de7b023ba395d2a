// Consider-Kalman filter on vehicles whose roll centre is known.
#include "rsi/estimation/consider_kalman.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/rsi/support/inertial_roll_vehicle.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/recorded_like_signals.hpp"
#include "tests/rsi/support/stages.hpp"

namespace consider_kalman_test {
namespace {

using rsi::RollCentreEstimate;
using rsi_test::InertialDeviation;
using rsi_test::InertialRollVehicle;

constexpr float speed_mps = 20.0F;
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

double wide(float value) {
    return static_cast<double>(value);
}

// Two seconds straight, then a turn of 6 m/s^2 entered within half a second.
double turn_mps2(double time_s) {
    return 6.0 * std::clamp(2.0 * (time_s - 2.0), 0.0, 1.0);
}

class Drive {
 public:
    explicit Drive(const InertialDeviation& deviation, bool noisy = false,
                   const rsi_parameters& parameters = rsi_test::large_suv())
        : vehicle_(parameters, deviation), noisy_(noisy) {
        estimator_.init(parameters);
    }

    RollCentreEstimate step(double parallel_mps2, float extended_rsi = 0.0F, float speed = speed_mps) {
        return estimator_.update(measure(parallel_mps2), extended_rsi, speed);
    }

    RollCentreEstimate turn_until(double time_s) {
        RollCentreEstimate estimate;
        for (; time_s_ < time_s; time_s_ += 0.01) {
            estimate = step(turn_mps2(time_s_));
        }
        return estimate;
    }

    rsi::Measurement measure(double parallel_mps2) {
        rsi::Measurement measured = vehicle_.drive(parallel_mps2);
        if (noisy_) {
            measured.road_parallel_force_mps2 += static_cast<float>(noise_(rsi_test::force_noise_mps2));
            measured.roll_rate_radps += static_cast<float>(noise_(rsi_test::rate_noise_radps));
            measured.roll_angle_rad += static_cast<float>(noise_(rsi_test::angle_noise_rad));
            measured.tan_roll_angle = std::tan(measured.roll_angle_rad);
        }
        return measured;
    }

    rsi_test::ConsiderKalman& estimator() { return estimator_; }

 private:
    InertialRollVehicle vehicle_;
    rsi_test::ConsiderKalman estimator_{};
    rsi_test::Noise noise_{5U};
    bool noisy_;
    double time_s_{0.0};
};

TEST(ConsiderKalman, FindsARollCentreThatHasMoved) {
    for (const double movement_m : {-0.06, -0.02, 0.0, 0.03}) {
        Drive drive({movement_m});
        EXPECT_NEAR(wide(drive.turn_until(5.0).vertical_movement_m), movement_m, 0.005) << movement_m;
    }
}

TEST(ConsiderKalman, FindsItThroughSensorNoise) {
    Drive drive({-0.05}, true);
    drive.turn_until(4.0);
    double square = 0.0;
    for (int k = 0; k < 300; ++k) {
        const double error = wide(drive.step(6.0).vertical_movement_m) + 0.05;
        square += error * error / 300.0;
    }
    EXPECT_LT(std::sqrt(square), 0.015);
}

// 0.03 g are 0.03 m: H times the offset over the force.
TEST(ConsiderKalman, LearnsASensorOffsetOnTheStraightAndDoesNotTakeItForAMovement) {
    for (const double offset_mps2 : {0.294, -0.294}) {
        InertialDeviation deviation;
        deviation.vertical_m = -0.03;
        deviation.offset_mps2 = offset_mps2;
        Drive drive(deviation);
        EXPECT_NEAR(wide(drive.turn_until(5.0).vertical_movement_m), -0.03, 0.012);
    }
}

TEST(ConsiderKalman, LearnsNothingBeforeItHasSeenAStraight) {
    Drive drive({-0.05});
    for (int k = 0; k < 500; ++k) {
        const RollCentreEstimate estimate = drive.step(6.0);
        ASSERT_EQ(estimate.vertical_movement_m, 0.0F);
        ASSERT_TRUE(estimate.frozen);
    }
}

TEST(ConsiderKalman, SeesTheSameInTheMirror) {
    Drive left({-0.05});
    Drive right({-0.05});
    for (int k = 0; k < 500; ++k) {
        const RollCentreEstimate one = left.step(turn_mps2(0.01 * k));
        const RollCentreEstimate other = right.step(-turn_mps2(0.01 * k));
        ASSERT_EQ(one.vertical_movement_m, other.vertical_movement_m);
        ASSERT_EQ(one.disturbance_nm, -other.disturbance_nm);
        ASSERT_EQ(one.inertia_moment_nm, -other.inertia_moment_nm);
        ASSERT_EQ(one.deviation_m, other.deviation_m);
    }
}

TEST(ConsiderKalman, GoesBackToTheNominalWithoutExcitation) {
    const rsi_parameters parameters = rsi_test::large_suv();
    Drive drive({-0.05});
    drive.turn_until(5.0);
    RollCentreEstimate estimate;
    for (int k = 0; k < 500; ++k) {
        estimate = drive.step(0.0);
    }
    EXPECT_TRUE(estimate.frozen);
    EXPECT_NEAR(wide(estimate.vertical_movement_m), 0.0, 0.05 * std::exp(-4.0));
    EXPECT_NEAR(wide(estimate.deviation_m), wide(parameters.roll_centre_prior_deviation_m), 1.0e-3);
}

// exp(-0.5 s / reversion time) is left after half a second without excitation and without rolling.
TEST(ConsiderKalman, GoesBackInItsReversionTime) {
    for (const float reversion_s : {0.5F, 2.0F}) {
        rsi_parameters parameters = rsi_test::large_suv();
        parameters.roll_centre_reversion_s = reversion_s;
        Drive drive({-0.05}, false, parameters);
        drive.turn_until(5.0);
        for (int k = 0; k < 200; ++k) {
            drive.step(0.0);  // the body comes to rest
        }
        const float before = drive.step(0.0).vertical_movement_m;
        float after = before;
        for (int k = 0; k < 50; ++k) {
            after = drive.step(0.0).vertical_movement_m;
        }
        EXPECT_NEAR(wide(after / before), std::exp(-0.5 / wide(reversion_s)), 0.03) << reversion_s;
    }
}

TEST(ConsiderKalman, HoldsItsEstimateNearWheelLift) {
    const rsi_parameters parameters = rsi_test::large_suv();
    Drive drive({-0.05});
    const RollCentreEstimate before = drive.turn_until(5.0);
    EXPECT_FALSE(before.frozen);
    RollCentreEstimate held;
    for (int k = 0; k < 100; ++k) {
        held = drive.step(9.0, 1.01F * parameters.freeze_level);
    }
    EXPECT_TRUE(held.frozen);
    EXPECT_EQ(held.vertical_movement_m, before.vertical_movement_m);
    EXPECT_GT(held.deviation_m, before.deviation_m);
    EXPECT_FALSE(drive.step(9.0, 0.99F * parameters.freeze_level).frozen);
    EXPECT_FALSE(drive.step(9.0, no_number).frozen);
}

TEST(ConsiderKalman, HoldsItsEstimateInHardBraking) {
    Drive drive({-0.05});
    const RollCentreEstimate before = drive.turn_until(5.0);
    float speed = speed_mps;
    RollCentreEstimate held;
    for (int k = 0; k < 100; ++k) {
        speed -= 0.05F;  // 5 m/s^2
        held = drive.step(6.0, 0.0F, speed);
    }
    EXPECT_TRUE(held.frozen);
    EXPECT_NEAR(wide(held.vertical_movement_m), wide(before.vertical_movement_m), 1.0e-3);
    EXPECT_FALSE(drive.step(6.0, 0.0F, no_number).frozen);  // an unknown speed holds nothing
}

// An observed angle follows from the calibrated roll equation; a filter that learnt from it would confirm
// itself.
TEST(ConsiderKalman, HoldsItsEstimateWhileTheObserverStandsInForTheRollSensor) {
    Drive drive({-0.05});
    const RollCentreEstimate before = drive.turn_until(5.0);
    RollCentreEstimate held;
    for (int k = 0; k < 100; ++k) {
        rsi::Measurement measured = drive.measure(6.0);
        measured.roll_angle_rad *= 0.9F;
        measured.roll_source = RSI_ROLL_OBSERVER;
        held = drive.estimator().update(measured, 0.0F, speed_mps);
        ASSERT_TRUE(held.frozen);
    }
    EXPECT_EQ(held.vertical_movement_m, before.vertical_movement_m);
    EXPECT_FALSE(drive.step(6.0).frozen);
}

TEST(ConsiderKalman, TakesASpeedThatNoVehicleHasForUnknown) {
    Drive drive({-0.05});
    drive.turn_until(5.0);
    for (const float speed : {-1.0F, 151.0F}) {
        EXPECT_FALSE(drive.step(6.0, 0.0F, speed).frozen) << speed;
        EXPECT_FALSE(drive.step(6.0).frozen);  // not compared with the one before
    }
}

// At 1.4 of the deviations of the stiffness that it assumes.
TEST(ConsiderKalman, KnowsHowFarAWrongStiffnessLeadsItAstray) {
    for (const double factor : {0.9, 1.1}) {
        InertialDeviation deviation;
        deviation.stiffness_factor = factor;
        Drive drive(deviation);
        const RollCentreEstimate estimate = drive.turn_until(6.0);
        const double error = std::fabs(wide(estimate.vertical_movement_m));
        EXPECT_GT(error, 0.02);  // otherwise the test would say nothing
        EXPECT_LT(error, 2.0 * wide(estimate.deviation_m));
    }
}

TEST(ConsiderKalman, IsMoreCertainInATurnThanBefore) {
    Drive drive({-0.05}, true);
    const float before = drive.turn_until(1.5).deviation_m;
    EXPECT_LT(drive.turn_until(4.0).deviation_m, 0.8F * before);
}

// 50 ms of a further 1 or 4 g, as from a kerb. Without the weight the estimate went to its limit of 0.25 m.
TEST(ConsiderKalman, IsNotMovedFarByABump) {
    for (const float bump_mps2 : {10.0F, 40.0F}) {
        Drive drive({-0.05});
        drive.turn_until(5.0);
        for (int k = 0; k < 50; ++k) {
            rsi::Measurement measured = drive.measure(6.0);
            measured.road_parallel_force_mps2 += (k < 5) ? bump_mps2 : 0.0F;
            const RollCentreEstimate estimate = drive.estimator().update(measured, 0.0F, speed_mps);
            ASSERT_NEAR(wide(estimate.vertical_movement_m), -0.05, 0.05);
        }
        EXPECT_NEAR(wide(drive.step(6.0).vertical_movement_m), -0.05, 0.03);
    }
}

TEST(ConsiderKalman, StaysWithinItsLimit) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_test::Noise noise(9U);
    rsi_test::ConsiderKalman estimator;
    estimator.init(parameters);
    for (int k = 0; k < 20000; ++k) {
        rsi::Measurement measured;
        measured.road_parallel_force_mps2 = static_cast<float>(noise(30.0));
        measured.road_normal_force_mps2 = static_cast<float>(1.0 + 50.0 * noise.unit());
        measured.roll_angle_rad = static_cast<float>(noise(0.8));
        measured.tan_roll_angle = std::tan(measured.roll_angle_rad);
        measured.roll_rate_radps = static_cast<float>(noise(5.0));
        const RollCentreEstimate estimate = estimator.update(measured, static_cast<float>(noise(1.0)),
                                                             static_cast<float>(30.0 * noise.unit()));
        ASSERT_LE(std::fabs(estimate.vertical_movement_m), parameters.roll_centre_limit_m);
        ASSERT_GT(estimate.deviation_m, 0.0F);
        ASSERT_LE(estimate.deviation_m, parameters.roll_centre_limit_m);
        ASSERT_TRUE(std::isfinite(estimate.disturbance_nm));
    }
}

TEST(ConsiderKalman, StartsAnewAfterAMeasurementThatIsNoNumber) {
    for (const float bad :
         {no_number, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::max()}) {
        Drive drive({-0.05});
        drive.turn_until(5.0);
        rsi::Measurement measured = drive.measure(6.0);
        measured.road_parallel_force_mps2 = bad;
        const RollCentreEstimate estimate = drive.estimator().update(measured, 0.0F, speed_mps);
        EXPECT_TRUE(estimate.frozen);
        EXPECT_TRUE(std::isfinite(estimate.vertical_movement_m));
        EXPECT_TRUE(std::isfinite(estimate.deviation_m));
        EXPECT_TRUE(std::isfinite(estimate.disturbance_nm));
        EXPECT_TRUE(std::isfinite(estimate.inertia_moment_nm));
        RollCentreEstimate after;
        for (int k = 0; k < 600; ++k) {
            after = drive.step(k < 300 ? 0.0 : 6.0);
        }
        EXPECT_NEAR(wide(after.vertical_movement_m), -0.05, 0.01);
    }
}

TEST(ConsiderKalman, KeepsWhatItHasLearntOverAGap) {
    Drive drive({-0.05});
    const float before = drive.turn_until(5.0).vertical_movement_m;
    drive.estimator().reset_signals();
    EXPECT_NEAR(wide(drive.step(6.0).vertical_movement_m), wide(before), 1.0e-3);
}

TEST(ConsiderKalman, RunsForAnHourWithoutLosingItsCovariance) {
    Drive drive({-0.05}, true);
    RollCentreEstimate estimate;
    for (int k = 0; k < 360000; ++k) {
        estimate = drive.step(6.0 * std::clamp(2.0 * std::sin(0.002 * k) - 1.0, 0.0, 1.0));
        ASSERT_GT(estimate.deviation_m, 5.0e-3F);
        ASSERT_LT(estimate.deviation_m, 0.1F);
    }
}

TEST(ConsiderKalman, TakesTheFirstSpeedAfterAGapAsItIs) {
    Drive drive({-0.05});
    drive.turn_until(5.0);
    EXPECT_FALSE(drive.step(6.0, 0.0F, no_number).frozen);
    EXPECT_FALSE(drive.step(6.0, 0.0F, 12.0F).frozen);
    drive.estimator().reset_signals();
    for (int k = 0; k < 50; ++k) {
        drive.step(6.0, 0.0F, 30.0F);  // until the lags have settled
    }
    EXPECT_FALSE(drive.step(6.0, 0.0F, 30.0F).frozen);
}

// Without lags nothing else hides the speed of before.
TEST(ConsiderKalman, ForgetsTheSpeedOverAGap) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.estimator_filter_lag_s = 0.0F;
    Drive drive({-0.05}, false, parameters);
    drive.turn_until(5.0);
    ASSERT_FALSE(drive.step(6.0, 0.0F, 20.0F).frozen);
    drive.estimator().reset_signals();
    drive.step(6.0, 0.0F, 40.0F);
    drive.step(6.0, 0.0F, 40.0F);
    EXPECT_FALSE(drive.step(6.0, 0.0F, 40.0F).frozen);
}

TEST(ConsiderKalman, TakesEverySpeedOfAVehicleUpToItsEndsForKnown) {
    const float changes[][2] = {{120.0F, 149.0F}, {10.0F, 0.0F}};
    for (const auto& change : changes) {
        Drive drive({-0.05});
        drive.turn_until(5.0);
        for (int k = 0; k < 100; ++k) {
            drive.step(6.0, 0.0F, change[0]);
        }
        EXPECT_FALSE(drive.step(6.0, 0.0F, change[0]).frozen);
        EXPECT_TRUE(drive.step(6.0, 0.0F, change[1]).frozen) << change[1];
    }
}

TEST(ConsiderKalman, GivesTheInertiasMomentAsItActsOnTheBody) {
    Drive drive({});
    drive.turn_until(2.1);
    EXPECT_LT(drive.step(6.0).inertia_moment_nm, -100.0F);  // it starts to roll to the outside
}

TEST(ConsiderKalman, AfterAResetItIsAsNew) {
    const rsi_parameters parameters = rsi_test::large_suv();
    InertialDeviation deviation;
    deviation.vertical_m = -0.05;
    deviation.offset_mps2 = 0.2;
    Drive used(deviation);
    used.turn_until(5.0);
    used.estimator().reset();
    rsi_test::ConsiderKalman fresh;
    fresh.init(parameters);
    InertialRollVehicle vehicle(parameters, deviation);
    for (int k = 0; k < 300; ++k) {
        const rsi::Measurement measured = vehicle.drive(turn_mps2(0.01 * k));
        const RollCentreEstimate one = used.estimator().update(measured, 0.0F, speed_mps);
        const RollCentreEstimate other = fresh.update(measured, 0.0F, speed_mps);
        ASSERT_EQ(one.vertical_movement_m, other.vertical_movement_m) << k;
        ASSERT_EQ(one.deviation_m, other.deviation_m) << k;
        ASSERT_EQ(one.frozen, other.frozen) << k;
    }
}

}  // namespace
}  // namespace consider_kalman_test
