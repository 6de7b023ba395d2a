// The judge of warnings: every limit is tested on both sides, so that none can be moved by a step.
#include "sil/judge/warning_judgement.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace warning_judgement_test {
namespace {

using sil::LoadBand;
using sil::WarningSide;
using sil::WarningState;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A run in cycles of 10 ms: the load transfer of each, and warning frames between.
class JudgedRun {
 public:
    // Adds this number of cycles with this load transfer.
    JudgedRun& drive(int cycles, double load_transfer_ratio) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            ++number_;
            judge_.observe(time_s(), load_transfer_ratio);
        }
        return *this;
    }
    // Arrives with the end of the latest cycle.
    JudgedRun& say(WarningState state, WarningSide side = WarningSide::none) {
        judge_.observe(state, side, time_s());
        return *this;
    }
    // Adds this number of cycles with this load transfer, and the same frame in each of them.
    JudgedRun& drive_saying(int cycles, double load_transfer_ratio, WarningState state, WarningSide side) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            drive(1, load_transfer_ratio).say(state, side);
        }
        return *this;
    }
    JudgedRun& warn(WarningSide side) { return say(WarningState::warning, side); }
    // The wheels have lifted so many cycles ago.
    JudgedRun& lift(WarningSide falling, int cycles_ago = 0) {
        judge_.lift_off({{0.01 * (number_ - cycles_ago), 0.0, 0.0}, falling});
        return *this;
    }
    sil::WarningJudgement judgement() const { return judge_.judgement(); }

 private:
    double time_s() const { return 0.01 * number_; }

    sil::WarningJudge judge_;
    int number_{-1};
};

// Ready from the beginning, so that no test sees the start-up.
JudgedRun ready() {
    return JudgedRun{}.drive(1, 0.01).say(WarningState::ready);
}

TEST(NamedWarnings, EachChangeOfSidesIsAWarning) {
    sil::NamedWarnings warnings;
    warnings.observe(WarningState::ready, WarningSide::none, 0.0);
    warnings.observe(WarningState::warning, WarningSide::none, 0.9);
    warnings.observe(WarningState::warning, WarningSide::left, 1.0);
    warnings.observe(WarningState::warning, WarningSide::none, 1.5);
    warnings.observe(WarningState::warning, WarningSide::left, 1.7);
    warnings.observe(WarningState::warning, WarningSide::none, 2.0);
    warnings.observe(WarningState::warning, WarningSide::right, 2.5);
    warnings.observe(WarningState::ready, WarningSide::none, 3.0);
    warnings.observe(WarningState::warning, WarningSide::right, 4.0);
    ASSERT_EQ(warnings.all().size(), 3U);
    const WarningSide sides[] = {WarningSide::left, WarningSide::right, WarningSide::right};
    const double begins_s[] = {1.0, 2.5, 4.0}, ends_s[] = {2.0, 2.5, 4.0};
    for (std::size_t place = 0U; place < 3U; ++place) {
        EXPECT_EQ(warnings.all()[place].side, sides[place]);
        EXPECT_EQ(warnings.all()[place].begin_s, begins_s[place]);
        EXPECT_EQ(warnings.all()[place].end_s, ends_s[place]);
    }
}

TEST(WarningJudge, WarnedMeansInForceWithTheFallingSideAtLiftOff) {
    const auto run = ready().drive(50, 0.8).warn(WarningSide::right).drive(30, 0.9).lift(WarningSide::right);
    const sil::WarningJudgement judged = run.judgement();
    EXPECT_TRUE(judged.lifted);
    EXPECT_EQ(judged.falling_side, WarningSide::right);
    EXPECT_EQ(judged.side_at_lift_off, WarningSide::right);
    EXPECT_NEAR(judged.lead_s.value(), 0.3, 1.0e-9);
    EXPECT_FALSE(judged.late);
}

TEST(WarningJudge, AWarningOfTheOtherSideIsNone) {
    const auto judged =
        ready().drive(50, 0.8).warn(WarningSide::left).drive(30, 0.9).lift(WarningSide::right).judgement();
    EXPECT_EQ(judged.side_at_lift_off, WarningSide::left);
    EXPECT_FALSE(judged.lead_s);
}

TEST(WarningJudge, LeadCountsFromTheLastChangeToTheFallingSide) {
    const auto judged = ready()
                            .drive(20, -0.9)
                            .warn(WarningSide::left)
                            .drive(80, -0.9)
                            .warn(WarningSide::right)
                            .drive(12, 0.9)
                            .lift(WarningSide::right)
                            .judgement();
    EXPECT_NEAR(judged.lead_s.value(), 0.12, 1.0e-9);
    EXPECT_EQ(judged.warnings, 1U);
}

TEST(WarningJudge, ABreakOfOneCycleBeginsTheLeadAnew) {
    const auto judged = ready()
                            .warn(WarningSide::right)
                            .drive(50, 0.9)
                            .say(WarningState::advisory, WarningSide::right)
                            .drive(1, 0.9)
                            .warn(WarningSide::right)
                            .drive(5, 0.9)
                            .lift(WarningSide::right)
                            .judgement();
    EXPECT_NEAR(judged.lead_s.value(), 0.05, 1.0e-9);
    EXPECT_EQ(judged.warnings, 2U);
    EXPECT_EQ(judged.advisories, 0U) << "one that a warning leaves is not another advisory";
}

TEST(WarningJudge, AWarningThatCameAndWentIsNone) {
    const auto judged = ready()
                            .warn(WarningSide::right)
                            .drive(50, 0.9)
                            .say(WarningState::ready)
                            .drive(1, 0.9)
                            .lift(WarningSide::right)
                            .judgement();
    EXPECT_FALSE(judged.lead_s);
    EXPECT_EQ(judged.side_at_lift_off, WarningSide::none);
    EXPECT_FALSE(judged.late);
}

TEST(WarningJudge, AWarningInTheVeryMomentIsInTimeAndOneCycleLaterLate) {
    const auto warned =
        ready().drive(10, 0.9).warn(WarningSide::right).drive(5, 1.0).lift(WarningSide::right, 5);
    EXPECT_EQ(warned.judgement().lead_s, 0.0);
    EXPECT_TRUE(sil::is_warned(warned.judgement().lead_s));
    const auto late =
        ready().drive(10, 0.9).warn(WarningSide::right).drive(5, 1.0).lift(WarningSide::right, 6);
    EXPECT_FALSE(late.judgement().lead_s);
    EXPECT_TRUE(late.judgement().late);
}

TEST(WarningJudge, ALateWarningMayComeAfterLiftOffIsKnown) {
    const auto run = ready().drive(10, 1.0).lift(WarningSide::left, 5);
    EXPECT_FALSE(run.judgement().late);
    EXPECT_FALSE(JudgedRun{run}.warn(WarningSide::right).judgement().late);
    EXPECT_TRUE(JudgedRun{run}.warn(WarningSide::left).judgement().late);
}

TEST(WarningJudge, OnlyAWarningOfTheFallingSideIsLate) {
    const auto run = ready().drive(10, 1.0).lift(WarningSide::left, 5);
    EXPECT_FALSE(JudgedRun{run}.say(WarningState::advisory, WarningSide::left).judgement().late);
    EXPECT_TRUE(JudgedRun{run}.warn(WarningSide::left).say(WarningState::ready).judgement().late)
        << "it came";
    EXPECT_FALSE(ready().warn(WarningSide::none).judgement().late) << "nothing has lifted";
    EXPECT_FALSE(ready().judgement().late);
}

TEST(WarningJudge, OnlyAWarningOfTheFallingSideIsLateWhereLiftOffIsKnownAfterIt) {
    const auto late = [](WarningState state, WarningSide side) {
        return ready()
            .drive(10, 1.0)
            .say(state, side)
            .drive(1, 1.0)
            .say(WarningState::ready)
            .drive(5, 1.0)
            .lift(WarningSide::right, 8)
            .judgement()
            .late;
    };
    EXPECT_TRUE(late(WarningState::warning, WarningSide::right));
    EXPECT_FALSE(late(WarningState::warning, WarningSide::left));
    EXPECT_FALSE(late(WarningState::advisory, WarningSide::right));
    const auto in_time_and_again = ready()
                                       .warn(WarningSide::right)
                                       .drive(10, 1.0)
                                       .say(WarningState::ready)
                                       .drive(1, 1.0)
                                       .warn(WarningSide::right)
                                       .drive(5, 1.0)
                                       .lift(WarningSide::right, 8);
    EXPECT_TRUE(in_time_and_again.judgement().lead_s);
    EXPECT_FALSE(in_time_and_again.judgement().late);
}

TEST(WarningJudge, TheWarningAfterLiftOffDoesNotMatter) {
    const auto judged = ready()
                            .warn(WarningSide::right)
                            .drive(40, 1.0)
                            .warn(WarningSide::left)
                            .drive(5, 1.0)
                            .lift(WarningSide::right, 6)
                            .warn(WarningSide::right)
                            .judgement();
    EXPECT_NEAR(judged.lead_s.value(), 0.39, 1.0e-9);
    EXPECT_FALSE(judged.late);
}

TEST(WarningJudge, ALeadIsEnoughFromTheWantedOneOnAndNotACycleLess) {
    EXPECT_TRUE(sil::is_warned(0.0));
    EXPECT_FALSE(sil::is_warned(std::nullopt));
    EXPECT_TRUE(sil::is_warned(2.0 - 1.9, sil::early_s));
    EXPECT_FALSE(sil::is_warned(0.099, sil::early_s));
    EXPECT_TRUE(sil::is_warned(2.0 - 1.8, sil::very_early_s));
    EXPECT_FALSE(sil::is_warned(0.199, sil::very_early_s));
    EXPECT_TRUE(sil::is_warned(-1.0e-6)) << "the rounding of times";
    EXPECT_FALSE(sil::is_warned(-1.05e-6));
    EXPECT_EQ(sil::early_s, 0.1);
    EXPECT_EQ(sil::very_early_s, 0.2);
}

TEST(WarningJudge, AWarningIsOnTheWrongSideFromATenthOfASecondAfterTheSwing) {
    // The load swings to the left wheels at the first of these cycles.
    const auto wrong_s = [](int cycles) {
        return ready().drive(30, 0.8).warn(WarningSide::right).drive(cycles, -0.8).judgement().wrong_side_s;
    };
    EXPECT_EQ(wrong_s(11), 0.0);
    EXPECT_NEAR(wrong_s(12), 0.01, 1.0e-9);
    EXPECT_NEAR(wrong_s(31), 0.2, 1.0e-9);
}

// Frames come in every cycle; only what changes in them counts.
TEST(WarningJudge, AFrameThatSaysTheSameChangesNothing) {
    const auto judged = ready()
                            .drive(30, -0.3)
                            .drive_saying(20, -0.3, WarningState::warning, WarningSide::right)
                            .drive_saying(20, 0.8, WarningState::warning, WarningSide::right)
                            .lift(WarningSide::right)
                            .judgement();
    EXPECT_NEAR(judged.wrong_side_s, 0.0, 1.0e-9) << "the load swung to that side in time";
    EXPECT_NEAR(judged.lead_s.value(), 0.39, 1.0e-9);
    EXPECT_EQ(judged.warnings, 1U);
}

TEST(WarningJudge, AWarningWithoutASideOrALoadOfNoneIsNotOnTheWrongOne) {
    EXPECT_EQ(ready().drive(30, 0.8).warn(WarningSide::none).drive(30, 0.8).judgement().wrong_side_s, 0.0);
    const auto in_the_air = JudgedRun{}.drive(30, nan).warn(WarningSide::left).drive(30, nan).judgement();
    EXPECT_EQ(in_the_air.wrong_side_s, 0.0);
    EXPECT_EQ(in_the_air.largest_load_transfer_ratio, 0.0);
}

TEST(WarningJudge, ALoadThatSwingsForthAndBackFasterThanAWarningCostsNothing) {
    const auto judged =
        ready().drive(30, 0.3).warn(WarningSide::right).drive(5, -0.3).drive(20, 0.8).judgement();
    EXPECT_EQ(judged.wrong_side_s, 0.0);
}

TEST(WarningJudge, AWarningOfTheLoadedSideIsNeverOnTheWrongOne) {
    EXPECT_EQ(ready().drive(30, 0.8).warn(WarningSide::right).drive(90, 0.001).judgement().wrong_side_s, 0.0);
    EXPECT_EQ(ready().drive(30, -0.8).warn(WarningSide::left).drive(90, -0.001).judgement().wrong_side_s,
              0.0);
}

TEST(WarningJudge, AWarningThatBeginsOnTheWrongSideIsSoAtOnceWithoutASwing) {
    const auto judged = ready().drive(30, 0.8).warn(WarningSide::left).drive(3, 0.8).judgement();
    EXPECT_NEAR(judged.wrong_side_s, 0.03, 1.0e-9);
}

TEST(WarningJudge, AWarningMayNameTheSideToWhichTheLoadSwingsWithinThreeTenths) {
    // Straight on to the left from the beginning, 0.3 s of it; then a warning of the right side; then the
    // swing.
    const auto wrong_s = [](int cycles, double then) {
        return ready()
            .drive(30, -0.3)
            .warn(WarningSide::right)
            .drive(cycles, -0.3)
            .drive(20, then)
            .judgement()
            .wrong_side_s;
    };
    EXPECT_NEAR(wrong_s(9, 0.8), 0.0, 1.0e-9);
    EXPECT_NEAR(wrong_s(29, 0.8), 0.0, 1.0e-9);
    EXPECT_NEAR(wrong_s(30, 0.8), 0.01, 1.0e-9);
    EXPECT_NEAR(wrong_s(49, 0.8), 0.2, 1.0e-9);
    EXPECT_NEAR(wrong_s(30, -0.3), 0.5, 1.0e-9);  // it does not swing
}

TEST(WarningJudge, ASideThatIsGivenUpBeforeTheSwingWasWrong) {
    const auto judged = ready()
                            .drive(30, -0.3)
                            .warn(WarningSide::right)
                            .drive(20, -0.3)
                            .warn(WarningSide::left)
                            .drive(5, -0.3)
                            .drive(20, 0.8)
                            .judgement();
    EXPECT_NEAR(judged.wrong_side_s, 0.2 + 0.09, 1.0e-9);  // and the left one from 0.1 s after the swing
}

TEST(WarningJudge, ASideThatIsGivenUpAndTakenBackBeforeTheSwingWasWrong) {
    const auto judged = ready()
                            .drive(30, -0.3)
                            .warn(WarningSide::right)
                            .drive(20, -0.3)
                            .warn(WarningSide::left)
                            .warn(WarningSide::right)
                            .drive(1, 0.8)
                            .judgement();
    EXPECT_NEAR(judged.wrong_side_s, 0.2 + 0.01 - 0.01, 1.0e-9);
}

TEST(WarningJudge, OnlyAWarningCanBeOnTheWrongSide) {
    const auto judged =
        ready().drive(30, 0.8).say(WarningState::advisory, WarningSide::left).drive(30, 0.8).judgement();
    EXPECT_EQ(judged.wrong_side_s, 0.0);
}

TEST(WarningJudge, InTheAirTheSideIsTheLastOne) {
    const auto judged =
        ready().drive(30, 0.8).drive(20, nan).warn(WarningSide::left).drive(5, nan).judgement();
    EXPECT_NEAR(judged.wrong_side_s, 0.05, 1.0e-9);
    EXPECT_DOUBLE_EQ(judged.largest_load_transfer_ratio, 0.8);
}

TEST(WarningJudge, CountsStatesAndTheirTimes) {
    const auto judged = ready()
                            .drive(10, 0.1)
                            .say(WarningState::advisory, WarningSide::right)
                            .drive(20, 0.5)
                            .warn(WarningSide::right)
                            .drive(30, 0.9)
                            .warn(WarningSide::left)
                            .drive(10, 0.9)
                            .say(WarningState::advisory, WarningSide::left)
                            .drive(5, 0.5)
                            .say(WarningState::ready)
                            .drive(5, 0.1)
                            .say(WarningState::advisory, WarningSide::left)
                            .drive(3, 0.1)
                            .say(WarningState::advisory, WarningSide::right)
                            .drive(2, 0.1)
                            .judgement();
    EXPECT_EQ(judged.warnings, 1U) << "a change of side is no other warning";
    EXPECT_EQ(judged.advisories, 2U);
    EXPECT_NEAR(judged.warning_s, 0.4, 1.0e-9);
    EXPECT_NEAR(judged.advisory_s, 0.3, 1.0e-9);
    EXPECT_EQ(judged.unavailable_s, 0.0);
}

TEST(WarningJudge, UnavailableCountsAfterTheStartUp) {
    EXPECT_EQ(JudgedRun{}.drive(51, 0.0).judgement().unavailable_s, 0.0);
    EXPECT_NEAR(JudgedRun{}.drive(52, 0.0).judgement().unavailable_s, 0.01, 1.0e-9);
    EXPECT_NEAR(JudgedRun{}.drive(60, 0.0).say(WarningState::ready).drive(9, 0.0).judgement().unavailable_s,
                0.09, 1.0e-9)
        << "a start-up that is too long";
    const auto later = ready().drive(100, 0.0).say(WarningState::unavailable).drive(7, 0.0).judgement();
    EXPECT_NEAR(later.unavailable_s, 0.07, 1.0e-9);
}

TEST(WarningJudge, UnavailableWithAnotherSideIsStillTheStartUp) {
    const auto judged = JudgedRun{}
                            .drive(1, 0.0)
                            .say(WarningState::unavailable, WarningSide::right)
                            .drive(20, 0.0)
                            .judgement();
    EXPECT_EQ(judged.unavailable_s, 0.0);
}

// However early it comes: with the first ready the start-up is over.
TEST(WarningJudge, UnavailableCountsOnceTheEcuHasBeenReady) {
    const auto judged = ready().drive(3, 0.0).say(WarningState::unavailable).drive(5, 0.0).judgement();
    EXPECT_NEAR(judged.unavailable_s, 0.05, 1.0e-9);
}

TEST(WarningJudge, TheLoadTransferIsALargestMagnitude) {
    EXPECT_DOUBLE_EQ(
        ready().drive(1, 0.3).drive(1, -0.75).drive(1, 0.2).judgement().largest_load_transfer_ratio, 0.75);
    EXPECT_EQ(ready().drive(1, -0.75).judgement().band(), LoadBand::from_0_7);
}

// Times are compared to the millionth of a second: that far before a limit is at the limit.
TEST(WarningJudge, ItsLimitsIncludeTheRoundingOfTimes) {
    constexpr double rounding_s = 1.0e-6;
    sil::WarningJudge start_up;
    for (const double time_s : {0.0, 0.5 - rounding_s, 1.0}) {
        start_up.observe(time_s, 0.0);
    }
    EXPECT_NEAR(start_up.judgement().unavailable_s, 0.5, 2.0e-6);
    sil::WarningJudge swing;
    swing.observe(WarningState::warning, WarningSide::left, 0.0);
    for (const double time_s : {0.0, 0.1 - rounding_s, 1.0}) {
        swing.observe(time_s, 0.8);
    }
    EXPECT_NEAR(swing.judgement().wrong_side_s, 0.9, 2.0e-6);
    sil::WarningJudge lift_off;
    lift_off.observe(WarningState::warning, WarningSide::right, rounding_s);
    lift_off.lift_off({{0.0, 0.0, 0.0}, WarningSide::right});
    EXPECT_EQ(lift_off.judgement().lead_s, 0.0) << "never less than none";
}

TEST(WarningInForce, OfNoSideIsNone) {
    sil::WarningInForce in_force;
    EXPECT_FALSE(in_force.lead_s(1.0, WarningSide::none));
    in_force.observe(WarningState::warning, WarningSide::none, 0.5);
    EXPECT_FALSE(in_force.lead_s(1.0, WarningSide::none));
    EXPECT_EQ(in_force.side(), WarningSide::none);
}

TEST(LoadBand, BeginsAtItsLimit) {
    EXPECT_EQ(sil::load_band(0.0), LoadBand::below_0_7);
    EXPECT_EQ(sil::load_band(0.699), LoadBand::below_0_7);
    EXPECT_EQ(sil::load_band(0.7), LoadBand::from_0_7);
    EXPECT_EQ(sil::load_band(0.799), LoadBand::from_0_7);
    EXPECT_EQ(sil::load_band(0.8), LoadBand::from_0_8);
    EXPECT_EQ(sil::load_band(0.899), LoadBand::from_0_8);
    EXPECT_EQ(sil::load_band(0.9), LoadBand::from_0_9);
    EXPECT_EQ(sil::load_band(1.0), LoadBand::from_0_9);
    EXPECT_STREQ(to_string(LoadBand::below_0_7), "below 0.7");
    EXPECT_STREQ(to_string(LoadBand::from_0_7), "0.7 to 0.8");
    EXPECT_STREQ(to_string(LoadBand::from_0_8), "0.8 to 0.9");
    EXPECT_STREQ(to_string(LoadBand::from_0_9), "0.9 to lift");
}

}  // namespace
}  // namespace warning_judgement_test
