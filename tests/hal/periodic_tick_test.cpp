// Behaviour of the periodic tick on a timer whose lateness the test decides; nothing sleeps.
#include "hal/linux/periodic_tick.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hal/linux/steady_clock.hpp"

namespace rsi::hal {
namespace periodic_tick_test {
namespace {

constexpr Time microseconds(std::int64_t count) {
    return Time{count * 1'000};
}
constexpr Time milliseconds(std::int64_t count) {
    return Time::from_milliseconds(count);
}

// Wakes its sleeper `lateness` after the deadline, and remembers every deadline.
struct ScriptedTimer {
    Time time{milliseconds(1000)};
    Time lateness{};
    std::vector<Time> deadlines{};

    Time now() const { return time; }
    void wait_until(Time deadline) {
        deadlines.push_back(deadline);
        time = deadline + lateness;
    }
    void work_for(Time duration) { time = time + duration; }
};

class PeriodicTickTest : public ::testing::Test {
 protected:
    ScriptedTimer timer;
    PeriodicTick<ScriptedTimer> tick{timer, milliseconds(10)};
};

TEST_F(PeriodicTickTest, DeadlinesLieOnePeriodApartFromTheStart) {
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(tick.wait(), 0U);
        timer.work_for(milliseconds(3));
    }
    EXPECT_EQ(timer.deadlines, (std::vector<Time>{milliseconds(1010), milliseconds(1020), milliseconds(1030),
                                                  milliseconds(1040)}));
    EXPECT_EQ(tick.ticks(), 4U);
    EXPECT_EQ(tick.overruns(), 0U);
    EXPECT_EQ(tick.missed_periods(), 0U);
}

TEST_F(PeriodicTickTest, IsShiftedForGood) {
    tick.wait();
    tick.shift(microseconds(100));
    tick.wait();
    tick.shift(microseconds(-300));
    tick.wait();
    tick.wait();
    EXPECT_EQ(timer.deadlines, (std::vector<Time>{milliseconds(1010), microseconds(1'020'100),
                                                  microseconds(1'029'800), microseconds(1'039'800)}));
    EXPECT_EQ(tick.missed_periods(), 0U);
}

TEST_F(PeriodicTickTest, LateWakeUpsDoNotShiftLaterDeadlines) {
    timer.lateness = microseconds(700);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(tick.wait(), 0U);
    }
    EXPECT_EQ(timer.deadlines.back(), milliseconds(1000 + 100 * 10));
}

TEST_F(PeriodicTickTest, WorkBeyondTheNextDeadlineIsAnOverrunAndTheCycleFollowsAtOnce) {
    tick.wait();                       // at 1010
    timer.work_for(milliseconds(12));  // until 1022; the deadline was 1020
    EXPECT_EQ(tick.wait(), 0U);        // late by 2 ms, but no period is lost
    EXPECT_EQ(timer.time, milliseconds(1022));
    EXPECT_EQ(tick.overruns(), 1U);
    EXPECT_EQ(tick.missed_periods(), 0U);
    EXPECT_EQ(tick.lateness().largest(), milliseconds(2));
    tick.wait();
    EXPECT_EQ(timer.deadlines.back(), milliseconds(1030));
}

TEST_F(PeriodicTickTest, WorkThatEndsExactlyAtTheDeadlineIsInTime) {
    tick.wait();
    timer.work_for(milliseconds(10));
    EXPECT_EQ(tick.wait(), 0U);
    EXPECT_EQ(tick.overruns(), 0U);
}

TEST_F(PeriodicTickTest, WholePeriodsThatPassUnusedAreReportedOnceAndNotMadeUpFor) {
    tick.wait();                       // at 1010
    timer.work_for(milliseconds(35));  // until 1045: 1020 is served late, 1030 and 1040 are missed
    EXPECT_EQ(tick.wait(), 2U);
    EXPECT_EQ(tick.missed_periods(), 2U);
    EXPECT_EQ(tick.overruns(), 1U);
    EXPECT_EQ(tick.wait(), 0U);
    EXPECT_EQ(timer.deadlines.back(), milliseconds(1050));
}

TEST_F(PeriodicTickTest, ALateWakeUpOfAWholePeriodIsMissedButNoOverrun) {
    timer.lateness = milliseconds(10);
    EXPECT_EQ(tick.wait(), 1U);
    EXPECT_EQ(tick.overruns(), 0U);
    timer.lateness = Time{};
    EXPECT_EQ(tick.wait(), 0U);
    EXPECT_EQ(timer.deadlines.back(), milliseconds(1030));
}

TEST_F(PeriodicTickTest, RestartBeginsANewSequenceFromNow) {
    timer.work_for(milliseconds(57));
    tick.restart();
    EXPECT_EQ(tick.wait(), 0U);
    EXPECT_EQ(timer.deadlines.back(), milliseconds(1067));
    EXPECT_EQ(tick.overruns(), 0U);
}

TEST_F(PeriodicTickTest, LatenessIsSummedUpInQuantiles) {
    for (int i = 1; i <= 100; ++i) {
        timer.lateness = microseconds(i * 10 - 2);  // 8, 18, ... 998 us
        tick.wait();
    }
    EXPECT_EQ(tick.lateness().quantile(0.5), microseconds(500));   // the 50th is 498 us, in the bin up to 500
    EXPECT_EQ(tick.lateness().quantile(0.99), microseconds(990));  // the 99th is 988 us
    EXPECT_EQ(tick.lateness().largest(), microseconds(998));
}

TEST(PeriodicTickOnTheSteadyClock, WakesAtOrAfterEachDeadline) {
    SteadyClock clock;
    const Time start = clock.now();
    PeriodicTick<SteadyClock> tick(clock, microseconds(200));
    for (int i = 0; i < 5; ++i) {
        tick.wait();
    }
    EXPECT_FALSE(clock.now() - start < microseconds(1000));
    EXPECT_EQ(tick.ticks(), 5U);
}

TEST(DurationHistogram, GivesZeroWhileNothingIsRecorded) {
    const DurationHistogram histogram;
    EXPECT_EQ(histogram.count(), 0U);
    EXPECT_EQ(histogram.largest(), Time{});
    EXPECT_EQ(histogram.quantile(0.5), Time{});
}

TEST(DurationHistogram, NeverGivesAQuantileAboveTheLargest) {
    DurationHistogram histogram;
    histogram.record(Time{1});
    EXPECT_EQ(histogram.quantile(0.5), Time{1});
    EXPECT_EQ(histogram.quantile(1.0), Time{1});
}

TEST(DurationHistogram, QuantilesAreTheTrueOnesRoundedUpToABin) {
    DurationHistogram histogram;
    for (const int length_us : {40, 1, 12, 7, 33}) {  // sorted: 1, 7, 12, 33, 40
        histogram.record(microseconds(length_us));
    }
    EXPECT_EQ(histogram.quantile(0.2), microseconds(5));
    EXPECT_EQ(histogram.quantile(0.5), microseconds(15));
    EXPECT_EQ(histogram.quantile(0.8), microseconds(35));
    EXPECT_EQ(histogram.quantile(1.0), microseconds(40));
    EXPECT_EQ(histogram.quantile(0.0), microseconds(5));
}

TEST(DurationHistogram, TheLowestQuantileIsThatOfTheShortest) {
    DurationHistogram histogram;
    histogram.record(microseconds(12));
    histogram.record(microseconds(40));
    EXPECT_EQ(histogram.quantile(0.0), microseconds(15));
}

TEST(DurationHistogram, KeepsWhatIsBeyondItsRangeInCountAndLargest) {
    DurationHistogram histogram;
    histogram.record(microseconds(1));
    histogram.record(milliseconds(50));
    histogram.record(milliseconds(3000));
    EXPECT_EQ(histogram.count(), 3U);
    EXPECT_EQ(histogram.largest(), milliseconds(3000));
    EXPECT_EQ(histogram.quantile(0.3), microseconds(5));
    EXPECT_EQ(histogram.quantile(0.5), milliseconds(3000));
}

TEST(DurationHistogram, TellsDurationsApartUpToTwentyMilliseconds) {
    DurationHistogram within;
    within.record(Time{19'999'999});
    within.record(milliseconds(3000));
    EXPECT_EQ(within.quantile(0.5), milliseconds(20));
    DurationHistogram beyond;
    beyond.record(milliseconds(20));
    beyond.record(milliseconds(3000));
    EXPECT_EQ(beyond.quantile(0.5), milliseconds(3000));
}

TEST(DurationHistogram, TakesNegativeDurationsAsZero) {
    DurationHistogram histogram;
    histogram.record(Time{-5});
    EXPECT_EQ(histogram.count(), 1U);
    EXPECT_EQ(histogram.largest(), Time{});
    EXPECT_EQ(histogram.quantile(0.5), Time{});
}

}  // namespace
}  // namespace periodic_tick_test
}  // namespace rsi::hal
