// The manoeuvres and what must come of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "tests/sil/acceptance/closed_run.hpp"

namespace rsi_test {
namespace manoeuvre_acceptance_test {
namespace {

constexpr double g_mps2 = 9.80665;
constexpr double degrees_per_radian = 57.295779513082321;

TEST(JTurn45, EndsInASteadyTurnWithoutAWarning) {
    const RunResult run = drive({"j-turn-45"});

    EXPECT_FALSE(run.events.one_wheel_lift.has_value());
    EXPECT_FALSE(run.reached(sil::WarningState::warning));
    EXPECT_LT(run.events.largest_lateral_acceleration_mps2, 0.8 * g_mps2);
    // Without a real turn the test would say nothing.
    EXPECT_GT(run.events.largest_lateral_acceleration_mps2, 0.6 * g_mps2);

    const auto last_two_seconds = run.truths.end() - 200;
    const auto by_roll = [](const sil::Truth& a, const sil::Truth& b) {
        return a.roll_angle_rad < b.roll_angle_rad;
    };
    const auto [smallest, largest] = std::minmax_element(last_two_seconds, run.truths.end(), by_roll);
    EXPECT_GT(smallest->roll_angle_rad * degrees_per_radian, 5.5);
    EXPECT_LT(largest->roll_angle_rad * degrees_per_radian, 6.8);
}

TEST(JTurn110, IsWarnedOfBeforeTwoWheelsLift) {
    const RunResult run = drive({"j-turn-110"});

    ASSERT_TRUE(run.events.warning.has_value());
    ASSERT_TRUE(run.events.two_wheel_lift.has_value());
    ASSERT_TRUE(run.events.ssf_crossing.has_value());
    EXPECT_EQ(run.events.warning_side, sil::WarningSide::right);
    EXPECT_GE(run.events.judgement.lead_s.value(), 0.3);
    EXPECT_GT(run.events.ssf_crossing->time_s, run.events.two_wheel_lift->time_s);
}

// The paper warns at 0.72 g.
TEST(JTurn110, IsWarnedOfByThePublishedIndicatorWhereThePaperSays) {
    RunSettings settings{"j-turn-110"};
    settings.changes = as_published;
    const RunResult run = drive(settings);

    ASSERT_TRUE(run.events.warning.has_value());
    ASSERT_TRUE(run.events.two_wheel_lift.has_value());
    EXPECT_GE(run.events.warning->lateral_acceleration_mps2, 0.70 * g_mps2);
    EXPECT_LE(run.events.warning->lateral_acceleration_mps2, 0.75 * g_mps2);
    EXPECT_GE(run.events.judgement.lead_s.value(), 0.2);
}

TEST(JTurn110, KeepsWarningUntilTheVehicleLiesOnItsSide) {
    const RunResult run = drive({"j-turn-110"});

    const auto first = std::find(run.states.begin(), run.states.end(), sil::WarningState::warning);
    ASSERT_NE(first, run.states.end());
    EXPECT_TRUE(std::all_of(first, run.states.end(),
                            [](sil::WarningState state) { return state == sil::WarningState::warning; }));
    EXPECT_GT(run.events.final_roll_angle_rad * degrees_per_radian, 60.0);
}

TEST(JTurn110, MirroredGivesTheMirroredResult) {
    const RunResult left = drive({"j-turn-110"});
    RunSettings settings{"j-turn-110"};
    settings.mirrored = true;
    const RunResult right = drive(settings);

    for (const sil::RunEvents* events : {&left.events, &right.events}) {
        ASSERT_TRUE(events->warning.has_value());
        ASSERT_TRUE(events->one_wheel_lift.has_value());
        ASSERT_TRUE(events->two_wheel_lift.has_value());
        ASSERT_TRUE(events->ssf_crossing.has_value());
    }
    EXPECT_EQ(right.events.warning_side, sil::WarningSide::left);
    EXPECT_NEAR(right.events.warning->time_s, left.events.warning->time_s, 0.01);
    EXPECT_NEAR(right.events.one_wheel_lift->time_s, left.events.one_wheel_lift->time_s, 0.01);
    EXPECT_NEAR(right.events.two_wheel_lift->time_s, left.events.two_wheel_lift->time_s, 0.01);
    EXPECT_NEAR(right.events.ssf_crossing->time_s, left.events.ssf_crossing->time_s, 0.01);
    EXPECT_NEAR(right.events.warning->lateral_acceleration_mps2,
                -left.events.warning->lateral_acceleration_mps2, 0.01 * g_mps2);
}

TEST(JTurn110, IsWarnedOfInTimeWithSensorNoise) {
    for (std::uint64_t seed = 1U; seed <= 10U; ++seed) {
        RunSettings settings{"j-turn-110"};
        settings.noise = true;
        settings.seed = seed;
        const RunResult run = drive(settings);

        ASSERT_TRUE(run.events.judgement.lead_s.has_value()) << "seed " << seed;
        EXPECT_GE(*run.events.judgement.lead_s, 0.2) << "seed " << seed;
        EXPECT_EQ(run.events.warning_side, sil::WarningSide::right) << "seed " << seed;
    }
}

// Roads and driving that are rough, but far from rollover.
class HarmlessManoeuvre : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(HarmlessManoeuvre, BringsNoWarning) {
    RunSettings settings{std::get<0>(GetParam()), std::get<1>(GetParam())};
    settings.noise = true;
    const RunResult run = drive(settings);

    EXPECT_FALSE(run.events.one_wheel_lift.has_value());
    EXPECT_FALSE(run.reached(sil::WarningState::warning));
    EXPECT_TRUE(run.reached(sil::WarningState::ready));
}

INSTANTIATE_TEST_SUITE_P(RoughAndFirm, HarmlessManoeuvre,
                         testing::Combine(testing::Values("step-steer", "rough-road", "banked-straight",
                                                          "one-sided-bump", "slow-ramp"),
                                          testing::Values("large_suv", "ordinary_suv")),
                         [](const testing::TestParamInfo<HarmlessManoeuvre::ParamType>& run) {
                             std::string name = std::get<0>(run.param) + "_" + std::get<1>(run.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(BankedJTurn, IsDrivenByTheAdaptedVehicle) {
    const RunResult run = drive({"j-turn-banked"});

    ASSERT_TRUE(run.events.two_wheel_lift.has_value());
    EXPECT_GT(run.events.final_roll_angle_rad * degrees_per_radian, 60.0);
    // The SSF of the raised vehicle, 1.6 / (2 1.1) = 0.727, is crossed on the bank long before wheels lift.
    ASSERT_TRUE(run.events.ssf_crossing.has_value());
    EXPECT_NEAR(run.events.ssf_crossing->lateral_acceleration_mps2, 0.727 * g_mps2, 0.01 * g_mps2);
}

TEST(Fishhook1a, RollsTheLargeSuvOver) {
    const RunResult run = drive({"fishhook-1a"});

    ASSERT_TRUE(run.events.one_wheel_lift.has_value());
    ASSERT_TRUE(run.events.two_wheel_lift.has_value());
    ASSERT_TRUE(run.events.ssf_crossing.has_value());
    EXPECT_LT(run.events.one_wheel_lift->time_s, run.events.two_wheel_lift->time_s);
    EXPECT_LT(run.events.two_wheel_lift->time_s, run.events.ssf_crossing->time_s);
    EXPECT_LT(run.events.final_roll_angle_rad * degrees_per_radian, -60.0);
}

class TenMinutes : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(TenMinutes, WithSensorNoiseBringNoWarning) {
    RunSettings settings{std::get<0>(GetParam()), std::get<1>(GetParam())};
    settings.noise = true;
    settings.duration_s = 600.0;
    const RunResult run = drive(settings);

    EXPECT_EQ(run.states.size(), 60001U);
    EXPECT_FALSE(run.reached(sil::WarningState::advisory));
    EXPECT_FALSE(run.reached(sil::WarningState::warning));
    // Ready from the tenth cycle on: a component that says "unavailable" would pass the above.
    EXPECT_EQ(std::count(run.states.begin(), run.states.end(), sil::WarningState::unavailable), 9);
    EXPECT_LT(run.largest_rsi, 0.9);
}

INSTANTIATE_TEST_SUITE_P(StraightAndSlalom, TenMinutes,
                         testing::Combine(testing::Values("straight", "slalom"),
                                          testing::Values("large_suv", "ordinary_suv")),
                         [](const testing::TestParamInfo<TenMinutes::ParamType>& run) {
                             return std::get<0>(run.param) + "_" + std::get<1>(run.param);
                         });

}  // namespace
}  // namespace manoeuvre_acceptance_test
}  // namespace rsi_test
