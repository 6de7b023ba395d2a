// Index score: at which threshold an index still warns, of the right side and in time.
#include "sil/judge/index_score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sil/files/calibration_file.hpp"

namespace index_score_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// Warns after two cycles at the level, ready after one, holds nothing; advisory out of the way.
rsi::Parameters plain_calibration() {
    rsi::Parameters calibration =
        sil::load_calibration(RSI_SOURCE_DIR "/firmware/calibrations/large_suv.toml");
    calibration.warning_on = 0.9F;
    calibration.warning_off = 0.9F;
    calibration.advisory_on = 0.8F;
    calibration.advisory_off = 0.8F;
    calibration.warning_confirmation_s = 0.02F;
    calibration.warning_hold_s = 0.0F;
    calibration.advisory_hold_s = 0.0F;
    calibration.recovery_s = 0.01F;
    return calibration;
}

// In cycles of 10 ms.
class Course {
 public:
    Course& add(int cycles, float level, float side = 1.0F, float opposite = 0.0F) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            course_.times_s.push_back(0.01 * static_cast<double>(course_.times_s.size()));
            course_.risks.push_back({level, side, opposite});
        }
        return *this;
    }
    double now_s() const { return course_.times_s.back(); }

    double alarm_threshold() const { return sil::alarm_threshold(course_, plain_calibration()); }
    bool alarms(double threshold) const { return sil::index_alarms(course_, plain_calibration(), threshold); }
    sil::IndexScore score() const { return sil::score_of(course_, plain_calibration(), {}); }
    // The wheels lift at the latest cycle.
    sil::IndexScore lifted(sil::WarningSide side = sil::WarningSide::right,
                           const rsi::Parameters& calibration = plain_calibration()) const {
        return lifted_at(now_s(), side, calibration);
    }
    sil::IndexScore lifted_at(double time_s, sil::WarningSide side = sil::WarningSide::right,
                              const rsi::Parameters& calibration = plain_calibration()) const {
        return sil::score_of(course_, calibration, sil::TwoWheelLiftOff{{time_s, 0.0, 0.0}, side});
    }

 private:
    sil::IndexCourse course_;
};

TEST(MatchedThreshold, AlarmsInAtLeastTheShare) {
    const std::vector<double> thresholds{0.2, 0.9, 0.4, 0.7, 0.0};
    EXPECT_EQ(sil::matched_threshold(thresholds, 0.2), 0.9);
    EXPECT_EQ(sil::matched_threshold(thresholds, 0.4), 0.7);  // 0.4 * 5 is not quite 2
    EXPECT_EQ(sil::matched_threshold(thresholds, 0.41), 0.4);
    EXPECT_EQ(sil::matched_threshold(thresholds, 2.0), 1.0e-9);
    EXPECT_EQ(sil::matched_threshold(thresholds, 0.0), std::numeric_limits<double>::infinity());
    EXPECT_EQ(sil::matched_threshold({}, 0.5), std::numeric_limits<double>::infinity());
    EXPECT_EQ(sil::matched_threshold(thresholds, 1.0), 1.0e-9);  // not 0, at which an index would warn always
}

// The threshold that is found lies within a step of the level that was reached.
void expect_reached(double threshold, double level) {
    EXPECT_LE(threshold, level * 1.000001);
    EXPECT_GT(threshold, level / 1.01);
}

TEST(IndexScore, OfARunWithoutLiftOffIsTheLevelThatLasts) {
    const sil::IndexScore score = Course{}.add(20, 0.3F).add(2, 0.7F).add(1, 2.0F).add(20, 0.3F).score();
    expect_reached(score.threshold, 0.7);
    EXPECT_EQ(score.threshold_100ms, score.threshold);
    EXPECT_EQ(score.threshold_200ms, score.threshold);
    EXPECT_FALSE(score.lead_s);
}

TEST(IndexScore, HasOneAmongTheThresholds) {
    EXPECT_EQ(Course{}.add(20, 0.3F).add(2, 1.0F).score().threshold, 1.0);
    EXPECT_LT(Course{}.add(20, 0.3F).add(2, 0.9999F).score().threshold, 1.0);
}

TEST(IndexScore, EndsAtTheSmallestAndTheLargestThreshold) {
    EXPECT_EQ(Course{}.add(20, 0.19F).score().threshold, 0.0);
    EXPECT_EQ(Course{}.add(20, 0.0F).score().threshold, 0.0);
    EXPECT_EQ(Course{}.add(20, nan).score().threshold, 0.0);
    EXPECT_EQ(Course{}.score().threshold, 0.0);
    expect_reached(Course{}.add(20, 0.205F).score().threshold, 0.205);
    expect_reached(Course{}.add(20, 20.0F).score().threshold, 5.0);
    EXPECT_EQ(Course{}.add(20, std::numeric_limits<float>::infinity()).score().threshold, 0.0);  // no level
}

TEST(IndexScore, OfALiftOffNeedsTheFallingSide) {
    const Course course = Course{}.add(20, 0.1F).add(30, 0.8F, -1.0F).add(30, 0.6F, 1.0F);
    expect_reached(course.lifted(sil::WarningSide::right).threshold, 0.6);
    EXPECT_EQ(course.lifted(sil::WarningSide::left).threshold, 0.0);
}

TEST(IndexScore, ALevelThatWentBackBeforeLiftOffIsNotInForce) {
    const Course course = Course{}.add(20, 0.1F).add(30, 0.8F).add(30, 0.5F);
    expect_reached(course.lifted().threshold, 0.5);
}

// The levels are confirmed in the second cycle: the lead is a cycle less than they last.
TEST(IndexScore, EveryLeadHasItsOwnThreshold) {
    const Course course = Course{}.add(20, 0.1F).add(10, 0.5F).add(10, 0.7F).add(12, 1.1F);
    const sil::IndexScore score = course.lifted();
    expect_reached(score.threshold, 1.1);
    expect_reached(score.threshold_100ms, 1.1);
    expect_reached(score.threshold_200ms, 0.7);
    EXPECT_NEAR(score.lead_s.value(), 0.10, 1.0e-9);
}

// An earlier lead never has the larger threshold, however small all of them are.
TEST(IndexScore, EveryLeadHasItsOwnThresholdBelowOneToo) {
    const sil::IndexScore score = Course{}.add(20, 0.1F).add(10, 0.3F).add(10, 0.5F).add(11, 0.8F).lifted();
    expect_reached(score.threshold, 0.8);
    expect_reached(score.threshold_100ms, 0.5);
    expect_reached(score.threshold_200ms, 0.3);
    EXPECT_FALSE(score.lead_s);
}

TEST(IndexScore, LeadIsThatOfTheThresholdOne) {
    const Course course = Course{}.add(20, 0.1F).add(10, 0.95F).add(10, 1.05F).add(12, 1.2F);
    EXPECT_NEAR(course.lifted().lead_s.value(), 0.20, 1.0e-9);
}

// Ready after the first cycle, confirmed in the second.
TEST(IndexScore, CountsFromTheFirstCycle) {
    const Course course = Course{}.add(12, 1.1F);
    expect_reached(course.lifted().threshold_100ms, 1.1);
    EXPECT_NEAR(course.lifted().lead_s.value(), 0.10, 1.0e-9);
}

// The left side stays named while its own risk lasts, on the scale of the level, until the right side's is a
// warning by itself.
TEST(IndexScore, TheOtherSidesRiskIsOnTheSameScale) {
    rsi::Parameters calibration = plain_calibration();
    calibration.warning_off = 0.7F;
    calibration.advisory_on = 0.65F;
    calibration.advisory_off = 0.6F;
    const Course course = Course{}.add(20, 0.1F).add(30, 0.46F, -1.0F).add(30, 0.4F, 1.0F, 0.35F);
    expect_reached(course.lifted(sil::WarningSide::left, calibration).threshold, 0.46);
    expect_reached(course.lifted(sil::WarningSide::right, calibration).threshold, 0.4);
}

TEST(IndexScore, ACycleLessIsTooLate) {
    const Course course = Course{}.add(20, 0.1F).add(10, 0.5F).add(10, 0.7F).add(11, 1.1F);
    const sil::IndexScore score = course.lifted();
    expect_reached(score.threshold, 1.1);
    expect_reached(score.threshold_100ms, 0.7);
    expect_reached(score.threshold_200ms, 0.5);
    EXPECT_NEAR(score.lead_s.value(), 0.09, 1.0e-9);
}

TEST(IndexScore, ALevelReachedAsTheWheelsLiftIsInTime) {
    expect_reached(Course{}.add(20, 0.4F).add(2, 0.8F).lifted().threshold, 0.8);
    expect_reached(Course{}.add(20, 0.4F).add(1, 0.8F).lifted().threshold, 0.4);
}

// The course goes on for a second after lift-off: what comes in it is too late.
TEST(IndexScore, ALevelReachedACycleAfterLiftOffIsTooLate) {
    const Course course = Course{}.add(20, 0.4F).add(30, 1.1F);  // in force from the second cycle of these
    const sil::IndexScore in_time = course.lifted_at(0.21);
    expect_reached(in_time.threshold, 1.1);
    EXPECT_NEAR(in_time.lead_s.value(), 0.0, 1.0e-9);
    const sil::IndexScore late = course.lifted_at(0.20);
    expect_reached(late.threshold, 0.4);
    EXPECT_FALSE(late.lead_s);
}

TEST(IndexScore, WithoutALevelThereIsNoLead) {
    const sil::IndexScore score = Course{}.add(20, 0.1F).lifted();
    EXPECT_EQ(score.threshold, 0.0);
    EXPECT_EQ(score.threshold_100ms, 0.0);
    EXPECT_EQ(score.threshold_200ms, 0.0);
    EXPECT_FALSE(score.lead_s);
}

TEST(IndexScore, FindsTheLargestThresholdWithAnAlarm) {
    Course course = Course{}.add(5, 0.1F).add(1, 0.9F).add(1, 0.4F).add(1, 0.5F).add(1, 0.2F);
    EXPECT_NEAR(course.alarm_threshold(), 0.4, 1e-6) << "two cycles confirm a warning";
    EXPECT_TRUE(course.alarms(0.39));
    EXPECT_FALSE(course.alarms(0.41));
    EXPECT_EQ(Course{}.add(5, 0.0F).alarm_threshold(), 0.0);
    EXPECT_EQ(Course{}.alarm_threshold(), 0.0);
}

TEST(IndexScore, TakesTheLargerRiskAndItsSide) {
    const rsi::RiskLevel right = sil::risk_of(0.7F, 0.2F);
    EXPECT_EQ(right.indicator, 0.7F);
    EXPECT_EQ(right.side, 1.0F);
    EXPECT_EQ(right.opposite, 0.2F);
    const rsi::RiskLevel left = sil::risk_of(0.2F, 0.7F);
    EXPECT_EQ(left.indicator, 0.7F);
    EXPECT_EQ(left.side, -1.0F);
    EXPECT_EQ(left.opposite, 0.2F);
    EXPECT_TRUE(std::isnan(sil::risk_of(nan, nan).indicator));
}

}  // namespace
}  // namespace index_score_test
