// J-turns of the large SUV: the ranges in which the paper's cases must come out.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"

namespace {

TEST(JTurn45, StaysOnAllWheelsBelowTheAdvertisedAccelerationAndSettlesNearSixDegrees) {
    for (const bool mirrored : {false, true}) {
        sil::RunOptions options;
        options.mirrored = mirrored;
        const scenario::Outcome outcome =
            scenario::drive(scenario::large_suv(), sil::find_manoeuvre("j-turn-45"), options);
        EXPECT_EQ(outcome.one_wheel_lift_s, scenario::not_yet);
        EXPECT_LT(outcome.largest_ay_g, 0.8);
        EXPECT_GT(outcome.largest_ay_g, 0.65);
        EXPECT_LT(outcome.largest_rsi, 1.0);
        EXPECT_GE(std::abs(outcome.final_roll_deg), 5.5);
        EXPECT_LE(std::abs(outcome.final_roll_deg), 6.8);
    }
}

TEST(JTurn110, CrossesThePublishedThresholdThenLiftsTwoWheelsThenCrossesTheStaticStabilityFactor) {
    for (const bool mirrored : {false, true}) {
        sil::RunOptions options;
        options.mirrored = mirrored;
        const scenario::Outcome outcome =
            scenario::drive(scenario::large_suv(), sil::find_manoeuvre("j-turn-110"), options);
        ASSERT_NE(outcome.two_wheel_lift_s, scenario::not_yet);
        ASSERT_NE(outcome.rsi_crossing_s, scenario::not_yet);
        EXPECT_GE(outcome.rsi_crossing_ay_g, 0.70);
        EXPECT_LE(outcome.rsi_crossing_ay_g, 0.75);
        EXPECT_GT(outcome.two_wheel_lift_s - outcome.rsi_crossing_s, 0.2);
        EXPECT_NEAR(outcome.two_wheel_lift_ay_g, 0.80, 0.01);
        EXPECT_GT(outcome.ssf_crossing_s, outcome.two_wheel_lift_s);
        EXPECT_LE(outcome.one_wheel_lift_s, outcome.two_wheel_lift_s);
        EXPECT_GT(std::abs(outcome.final_roll_deg), 60.0);
    }
}

TEST(JTurn110, StaysFiniteAndAboveTheRoadLongAfterItLiesOnItsSide) {
    sil::RunOptions options;
    options.duration_s = 20.0;
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("j-turn-110"), options};
    while (!run.finished()) {
        run.step();
        const sil::Truth& truth = run.truth();
        ASSERT_TRUE(std::isfinite(truth.roll_angle_rad));
        ASSERT_TRUE(std::isfinite(truth.specific_force_mps2[1]));
        ASSERT_TRUE(std::isfinite(truth.lateral_acceleration_mps2));
        ASSERT_GT(truth.position_z_m, 0.2);
        ASSERT_LT(truth.position_z_m, 3.0);
    }
    EXPECT_NEAR(std::hypot(run.truth().speed_mps, run.truth().lateral_velocity_mps), 0.0, 0.5);
}

TEST(JTurn110, LeavesTheOrdinarySuvOnItsWheels) {
    const scenario::Outcome outcome =
        scenario::drive(scenario::ordinary_suv(), sil::find_manoeuvre("j-turn-110"));
    EXPECT_EQ(outcome.two_wheel_lift_s, scenario::not_yet);
    EXPECT_LT(std::abs(outcome.final_roll_deg), 10.0);
}

}  // namespace
