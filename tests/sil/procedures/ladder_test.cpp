// Speed ladder, tilt table and steady circle: limits on both sides, and where a series ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sil/studies/procedures/speed_ladder.hpp"
#include "sil/studies/procedures/steady_circle.hpp"
#include "sil/studies/procedures/tilt_table.hpp"
#include "tests/sil/procedures/shipped_world.hpp"

namespace {

using testing_procedures::shipped;

sil::Truth with_gaps(double front_left, double front_right, double rear_left, double rear_right) {
    sil::Truth truth;
    truth.wheel_gap_m = {front_left, front_right, rear_left, rear_right};
    return truth;
}

TEST(TwoWheelHeight, IsThatOfTheLowerWheelOfTheHigherSide) {
    EXPECT_DOUBLE_EQ(sil::two_wheel_height_m(with_gaps(0.05, 0.0, 0.03, 0.0)), 0.03);
    EXPECT_DOUBLE_EQ(sil::two_wheel_height_m(with_gaps(0.0, 0.02, 0.0, 0.07)), 0.02);
    EXPECT_DOUBLE_EQ(sil::two_wheel_height_m(with_gaps(0.09, 0.0, 0.0, 0.09)), 0.0);
}

TEST(TwoWheelLift, IsTwoInches) {
    EXPECT_TRUE(sil::two_wheel_lift_criterion(0.050799, "").met());
    EXPECT_FALSE(sil::two_wheel_lift_criterion(0.0508, "").met());
}

TEST(TwoWheelLiftMeasurement, EndsWhenTheLiftHasLastedAndKnowsTheEntranceSpeed) {
    sil::TwoWheelLiftMeasurement measurement{2.0};
    for (int step = 1; step <= 2549; ++step) {
        sil::Truth truth = with_gaps(step >= 2500 ? 0.06 : 0.05, 0.0, 0.06, 0.0);
        truth.time_s = step * 0.001;
        truth.speed_mps = step < 2000 ? 1.0 : (step == 2000 ? 20.0 : 15.0);
        measurement.step(truth);
        ASSERT_FALSE(measurement.finished());
    }
    sil::Truth last = with_gaps(0.0, 0.0, 0.0, 0.0);
    last.time_s = 2.5501;
    measurement.step(last);
    EXPECT_TRUE(measurement.finished());
    EXPECT_DOUBLE_EQ(measurement.height_m(), 0.06);
    EXPECT_DOUBLE_EQ(measurement.entry_speed_mps().value_or(0.0), 20.0);
}

std::vector<std::string> names(const std::vector<sil::ProcedureStep>& steps) {
    std::vector<std::string> found;
    for (const sil::ProcedureStep& step : steps) {
        found.push_back(step.series + " " + step.name);
    }
    return found;
}

TEST(SpeedLadder, EndsEachSeriesWithTheFirstTwoWheelLift) {
    for (const char* name : {"fishhook-1a", "fishhook-1b", "j-turn"}) {
        const sil::ProcedureResult result = sil::find_procedure(name).run(shipped("large_suv"));
        EXPECT_THAT(names(result.steps),
                    testing::ElementsAre("left 35 mph", "left 40 mph", "right 35 mph", "right 40 mph"))
            << name;
        EXPECT_EQ(result.outcome, sil::ProcedureOutcome::not_met) << name;
        EXPECT_EQ(result.results[0].value, 40.0) << name;
        EXPECT_TRUE(result.steps[0].met()) << name;
        EXPECT_FALSE(result.steps[1].met()) << name;
        EXPECT_TRUE(result.steps[1].warning.lead_s) << name;
    }
}

TEST(SpeedLadder, GoesToTheLastSpeedOfTheRuleWithoutALift) {
    const auto speeds = [](const char* name) {
        const sil::ProcedureResult result = sil::find_procedure(name).run(shipped("ordinary_suv"));
        EXPECT_EQ(result.outcome, sil::ProcedureOutcome::met) << name;
        EXPECT_FALSE(result.results[0].value) << name;
        std::vector<std::string> left = names(result.steps);
        left.resize(left.size() / 2U);
        return left;
    };
    EXPECT_THAT(speeds("fishhook-1a"),
                testing::ElementsAre("left 35 mph", "left 40 mph", "left 45 mph", "left 50 mph"));
    EXPECT_THAT(speeds("fishhook-1b"), testing::ElementsAre("left 35 mph", "left 40 mph", "left 45 mph",
                                                            "left 47.5 mph", "left 50 mph"));
    EXPECT_THAT(speeds("j-turn"), testing::ElementsAre("left 35 mph", "left 40 mph", "left 45 mph",
                                                       "left 50 mph", "left 55 mph", "left 60 mph"));
}

TEST(SpeedLadder, SteersSixAndAHalfOrEightTimesTheAngleOfThreeTenths) {
    for (const auto& [name, factor] : {std::pair{"fishhook-1b", 6.5}, std::pair{"j-turn", 8.0}}) {
        const sil::ProcedureResult result = sil::find_procedure(name).run(shipped("van"));
        EXPECT_NEAR(*result.steps[0].figures[0].value, factor * *result.before[0].value, 1e-6) << name;
    }
}

TEST(TiltTable, AsksForTwentyThreeDegrees) {
    EXPECT_TRUE(sil::tilt_criterion(23.0001 * 3.14159265358979323846 / 180.0).met());
    EXPECT_FALSE(sil::tilt_criterion(22.9999 * 3.14159265358979323846 / 180.0).met());
}

TEST(TiltTable, LiftsTheHighSideBeforeHalfTrackOverHeightAndFallsToTheLow) {
    for (const char* name : {"large_suv", "ordinary_suv", "van"}) {
        const sil::ProcedureWorld world = shipped(name);
        const sil::ProcedureResult result = sil::find_procedure("tilt-table").run(world);
        ASSERT_EQ(result.steps.size(), 2U);
        EXPECT_EQ(result.steps[0].series, "right");
        EXPECT_EQ(result.steps[0].warning.falling_side, sil::WarningSide::right) << name;
        EXPECT_EQ(result.steps[1].warning.falling_side, sil::WarningSide::left) << name;
        const double threshold_g = *result.results[1].value;
        EXPECT_LT(threshold_g, sil::static_stability_factor(world.vehicle)) << name;
        EXPECT_GT(threshold_g, 0.85 * sil::static_stability_factor(world.vehicle)) << name;
    }
}

sil::SteadyTurn turn(double acceleration_mps2, double curvature_pm, double roll_rad = 0.0) {
    sil::SteadyTurn made;
    made.lateral_acceleration_mps2 = acceleration_mps2;
    made.curvature_pm = curvature_pm;
    made.roll_rad = roll_rad;
    return made;
}

TEST(SteadyCircle, IsKeptWithinTwoPerCentOfItsCurvature) {
    EXPECT_TRUE(sil::is_on_circle(turn(1.0, 0.01019), 100.0));
    EXPECT_FALSE(sil::is_on_circle(turn(1.0, 0.01021), 100.0));
    EXPECT_TRUE(sil::is_on_circle(turn(1.0, 0.00981), 100.0));
    EXPECT_FALSE(sil::is_on_circle(turn(1.0, 0.00979), 100.0));
    EXPECT_FALSE(sil::is_on_circle(std::nullopt, 100.0));
}

TEST(SteadyCircle, GradientIsThatOfTheTurnsFromOneToFour) {
    const std::vector<sil::SteadyTurn> turns = {turn(0.5, 0.01, 9.0), turn(1.0, 0.01, 0.02),
                                                turn(2.5, 0.01, 0.05), turn(4.0, 0.01, 0.08),
                                                turn(4.5, 0.01, 9.0)};
    EXPECT_NEAR(sil::gradient(turns, &sil::SteadyTurn::roll_rad).value_or(0.0), 0.02, 1e-12);
    EXPECT_FALSE(sil::gradient({turn(2.0, 0.01)}, &sil::SteadyTurn::roll_rad));
}

TEST(SteadyCircle, GrowsByHalfAMetrePerSecondSquaredUntilItIsNotKeptOrTwoWheelsLift) {
    for (const char* name : {"ordinary_suv", "van"}) {
        const sil::ProcedureResult result = sil::find_procedure("steady-circle").run(shipped(name));
        EXPECT_EQ(result.outcome, sil::ProcedureOutcome::measured);
        const std::size_t half = result.steps.size() / 2U;
        for (std::size_t i = 0U; i + 1U < half; ++i) {
            const sil::ProcedureStep& step = result.steps[i];
            EXPECT_FALSE(step.warning.lifted) << name << step.name;
            EXPECT_NEAR(*step.figures[2].value, 100.0, 2.1) << name << step.name;
            EXPECT_NEAR(*step.figures[1].value, 0.5 * static_cast<double>(i + 1U), 0.2) << name << step.name;
        }
        const sil::ProcedureStep& last = result.steps[half - 1U];
        EXPECT_TRUE(last.warning.lifted || std::abs(*last.figures[2].value - 100.0) > 1.9) << name;
        EXPECT_GT(*result.results[0].value, 0.0) << name;  // understeers
        EXPECT_GT(*result.results[1].value, 3.0) << name;  // and leans outwards
    }
}

}  // namespace
