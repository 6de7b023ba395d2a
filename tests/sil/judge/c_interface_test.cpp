// C interface: the same answers as the C++ beside it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "sil/judge/detection.hpp"
#include "sil/judge/judge.h"

namespace c_interface_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint8_t left = 1U;
constexpr std::uint8_t right = 2U;

TEST(JudgeInterface, HasTheConstants) {
    EXPECT_EQ(judge_early_s, sil::early_s);
    EXPECT_EQ(judge_very_early_s, sil::very_early_s);
    EXPECT_EQ(judge_time_rounding_s, sil::time_rounding_s);
    EXPECT_EQ(judge_lasting_s, sil::TwoWheelLiftObserver::lasting_s);
    EXPECT_EQ(judge_fewest_clusters, sil::fewest_clusters);
    EXPECT_STREQ(judge_band_name(0U), "below 0.7");
    EXPECT_STREQ(judge_band_name(3U), "0.9 to lift");
}

// Two lift-offs, the second one warned of 0.15 s before; two others, of which the first is calm and has an
// alarm.
struct FourRuns {
    std::vector<std::uint32_t> vehicles{0U, 0U, 1U, 1U};
    std::vector<double> lifts_s{3.0, 4.0, none, none};
    std::vector<double> ratios{1.0, 1.0, 0.75, 0.95};
    std::vector<double> leads_s{none, 0.15, none, none};
    std::vector<std::uint8_t> alarms{1U, 1U, 1U, 0U};
    judge_runs runs{4U, vehicles.data(), lifts_s.data(), ratios.data(), leads_s.data(), alarms.data()};
};

TEST(JudgeInterface, TellsEachRun) {
    FourRuns four;
    four.runs.vehicles = nullptr;
    using Bytes = std::array<std::uint8_t, 4>;
    Bytes lifted{}, calm{}, warned{}, early{}, very_early{}, band{};
    judge_each(&four.runs, lifted.data(), calm.data(), warned.data(), early.data(), very_early.data(),
               band.data());
    EXPECT_EQ(lifted, (Bytes{1U, 1U, 0U, 0U}));
    EXPECT_EQ(calm, (Bytes{0U, 0U, 1U, 0U}));
    EXPECT_EQ(warned, (Bytes{0U, 1U, 0U, 0U}));
    EXPECT_EQ(early, (Bytes{0U, 1U, 0U, 0U}));
    EXPECT_EQ(very_early, (Bytes{0U, 0U, 0U, 0U}));
    EXPECT_EQ(band, (Bytes{3U, 3U, 1U, 3U}));
}

TEST(JudgeInterface, DetectsOverRuns) {
    const FourRuns four;
    judge_detection found{};
    judge_detect(&four.runs, &found);
    EXPECT_EQ(found.warned.count, 1U);
    EXPECT_EQ(found.warned.total, 2U);
    const sil::ConfidenceInterval interval = sil::wilson_interval(1.0, 2.0);
    EXPECT_EQ(found.warned.lowest, interval.lowest);
    EXPECT_EQ(found.warned.highest, interval.highest);
    EXPECT_EQ(found.warned_100ms.count, 1U);
    EXPECT_EQ(found.warned_200ms.count, 0U);
    EXPECT_EQ(found.false_alarms.count, 1U);
    EXPECT_EQ(found.false_alarms.total, 1U);
    EXPECT_EQ(found.alarms[1].count, 1U);
    EXPECT_EQ(found.alarms[3].count, 0U);
    EXPECT_EQ(found.alarms[3].total, 1U);
    EXPECT_EQ(found.median_lead_s, 0.075);
}

TEST(JudgeInterface, FindsTheLeadOfNamedSides) {
    const std::array<double, 3> times_s{1.0, 1.5, 2.0};
    const std::array<std::uint8_t, 3> sides{right, left, 0U};
    EXPECT_DOUBLE_EQ(judge_lead_s(3U, times_s.data(), sides.data(), 1.75, left), 0.25);
    EXPECT_TRUE(std::isnan(judge_lead_s(3U, times_s.data(), sides.data(), 1.75, right)));
    EXPECT_TRUE(std::isnan(judge_lead_s(3U, times_s.data(), sides.data(), 2.0, left)));
}

// At once and without memory.
constexpr judge_calibration quick{0.8F, 0.8F, 0.9F, 0.9F, 0.0F, 0.0F, 0.0F, 0.0F};

TEST(JudgeInterface, PutsAnIndexBehindTheWarningStates) {
    const std::array<double, 4> times_s{0.0, 0.01, 0.02, 0.03};
    const std::array<double, 4> rising{0.0, 0.5, 1.0, 1.0};
    const std::array<double, 4> nothing{};
    const judge_course course{4U, times_s.data(), nothing.data(), rising.data()};
    EXPECT_DOUBLE_EQ(judge_index_lead_s(&quick, &course, 1.0, 0.03, left), 0.01);
    EXPECT_DOUBLE_EQ(judge_index_lead_s(&quick, &course, 0.5, 0.03, left), 0.02);
    EXPECT_TRUE(std::isnan(judge_index_lead_s(&quick, &course, 1.0, 0.03, right)));
    EXPECT_EQ(judge_alarms(&quick, &course, 1.0), 1);
    EXPECT_EQ(judge_alarms(&quick, &course, 1.01), 0);
    EXPECT_NEAR(judge_alarm_threshold(&quick, &course), 1.0, 1e-6);
}

// Each parameter in its place: what one of them changes.
TEST(JudgeInterface, HandsOnEveryParameter) {
    const std::array<double, 6> times_s{0.0, 0.01, 0.02, 0.03, 0.04, 0.05};
    const std::array<double, 6> levels{0.85, 1.0, 1.0, 0.6, 0.95, 0.0};
    const std::array<double, 6> nothing{};
    const judge_course course{6U, times_s.data(), levels.data(), nothing.data()};
    const auto lead_s = [&](const judge_calibration& calibration, double lift_off_time_s) {
        return judge_index_lead_s(&calibration, &course, 1.0, lift_off_time_s, right);
    };
    EXPECT_DOUBLE_EQ(lead_s(quick, 0.02), 0.01);
    EXPECT_TRUE(std::isnan(lead_s(quick, 0.04)));
    judge_calibration changed = quick;
    changed.warning_confirmation_s = 0.02F;
    EXPECT_DOUBLE_EQ(lead_s(changed, 0.02), 0.0);
    changed = quick;
    changed.recovery_s = 0.03F;
    EXPECT_DOUBLE_EQ(lead_s(changed, 0.02), 0.0);
    changed = quick;
    changed.warning_hold_s = 0.04F;
    EXPECT_DOUBLE_EQ(lead_s(changed, 0.04), 0.03);
    changed = quick;
    changed.warning_off = 0.5F;
    EXPECT_DOUBLE_EQ(lead_s(changed, 0.03), 0.02);
    EXPECT_TRUE(std::isnan(lead_s(quick, 0.03)));
}

// The other side is the riskier one, below the level of the state.
TEST(JudgeInterface, HandsOnTheLevelBelowWhichASideGivesWay) {
    const std::array<double, 3> times_s{0.0, 0.01, 0.02};
    const std::array<double, 3> one{1.0, 0.91, 0.91};
    const std::array<double, 3> other{0.0, 0.94, 0.94};
    const judge_course course{3U, times_s.data(), one.data(), other.data()};
    judge_calibration held = quick;
    held.warning_hold_s = 1.0F;
    EXPECT_DOUBLE_EQ(judge_index_lead_s(&held, &course, 1.0, 0.02, right), 0.02);
    held.advisory_off = 0.83F;
    EXPECT_TRUE(std::isnan(judge_index_lead_s(&held, &course, 1.0, 0.02, right)));
}

// A warning to the right from 0.02 s on, after an advisory of one cycle; the left wheels lift at 0.05 s.
struct SixCycles {
    std::array<double, 6> times_s{0.0, 0.01, 0.02, 0.03, 0.04, 0.05};
    std::array<std::int32_t, 6> states{1, 2, 3, 3, 3, 3};
    std::array<std::int32_t, 6> sides{0, 2, 2, 2, 2, 2};
    std::array<double, 6> ratios{0.1, 0.4, none, 0.8, 0.95, 1.0};
    judge_drive drive{6U, times_s.data(), states.data(), sides.data(), ratios.data(), 0.05, right};

    judge_judgement judged() const {
        judge_judgement found{};
        judge_warnings(&drive, &found);
        return found;
    }
};

TEST(JudgeInterface, JudgesTheWarningsOfADrive) {
    const judge_judgement found = SixCycles{}.judged();
    EXPECT_EQ(found.lifted, 1U);
    EXPECT_EQ(found.side_at_lift_off, right);
    EXPECT_EQ(found.late, 0U);
    EXPECT_DOUBLE_EQ(found.lead_s, 0.03);
    EXPECT_DOUBLE_EQ(found.warning_s, 0.03);
    EXPECT_DOUBLE_EQ(found.advisory_s, 0.01);
    EXPECT_EQ(found.unavailable_s, 0.0);
    EXPECT_EQ(found.wrong_side_s, 0.0);
    EXPECT_EQ(found.warnings, 1U);
    EXPECT_EQ(found.advisories, 1U);
    EXPECT_EQ(found.largest_load_transfer_ratio, 1.0);
}

TEST(JudgeInterface, JudgesADriveWithoutLiftOff) {
    SixCycles six;
    six.drive.lift_off_time_s = none;
    const judge_judgement found = six.judged();
    EXPECT_EQ(found.lifted, 0U);
    EXPECT_TRUE(std::isnan(found.lead_s));
    EXPECT_EQ(found.warnings, 1U);
    EXPECT_EQ(found.band, 3U);
    six.ratios[4] = six.ratios[5] = -0.85;
    EXPECT_EQ(six.judged().band, 2U);
}

TEST(JudgeInterface, KnowsALateWarningAndOneOfTheWrongSide) {
    SixCycles six;
    six.drive.lift_off_time_s = 0.015;
    EXPECT_EQ(six.judged().late, 1U);
    EXPECT_TRUE(std::isnan(six.judged().lead_s));
    six.drive.lift_off_time_s = 0.05;
    six.drive.falling_side = left;
    EXPECT_TRUE(std::isnan(six.judged().lead_s));
    six.sides.fill(left);
    // Long enough for the load to have swung.
    six.times_s = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
    six.drive.lift_off_time_s = none;
    EXPECT_DOUBLE_EQ(six.judged().wrong_side_s, 3.0);
    six.states = {0, 0, 0, 1, 1, 1};
    EXPECT_DOUBLE_EQ(six.judged().unavailable_s, 2.0);
}

TEST(JudgeInterface, MatchesAShareOfAlarms) {
    const std::array<double, 3> thresholds{0.2, 0.9, 0.5};
    EXPECT_EQ(judge_matched_threshold(3U, thresholds.data(), 0.4), 0.5);
}

TEST(JudgeInterface, CountsByVehicle) {
    const std::array<std::size_t, 2> counts{1U, 3U};
    const std::array<std::size_t, 2> totals{4U, 4U};
    judge_share share{};
    judge_share_by_vehicle(2U, counts.data(), totals.data(), &share);
    EXPECT_EQ(share.count, 4U);
    EXPECT_EQ(share.total, 8U);
    double lowest = 0.0;
    double highest = 0.0;
    judge_wilson_interval(4.0, 8.0, &lowest, &highest);
    EXPECT_EQ(share.lowest, lowest);
    EXPECT_EQ(share.highest, highest);
}

}  // namespace
}  // namespace c_interface_test
