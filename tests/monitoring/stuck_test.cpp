// Signals that repeat themselves: how many equal values, and how much others must move meanwhile.
#include <gtest/gtest.h>

#include <limits>

#include "rsi/ecu/monitoring/steering_check.hpp"
#include "rsi/ecu/monitoring/stuck_check.hpp"

namespace monitoring_stuck_test {
namespace {

using rsi::monitoring::SteeringCheck;
using rsi::monitoring::StuckCheck;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

// A value of 1 against a reference that must span 2 before the value counts as stuck.
class AStuckCheck : public ::testing::Test {
 protected:
    bool run(int samples, float value, float reference) {
        bool stuck = false;
        for (int sample = 0; sample < samples; ++sample) {
            stuck = check.is_stuck(value, reference);
        }
        return stuck;
    }

    StuckCheck check{2.0F};
};

TEST_F(AStuckCheck, Wants21EqualValues) {
    run(1, 1.0F, 0.0F);
    EXPECT_FALSE(run(19, 1.0F, 3.0F));
    EXPECT_TRUE(run(1, 1.0F, 3.0F));
    EXPECT_TRUE(run(1000, 1.0F, 3.0F));
    EXPECT_FALSE(run(1, 1.001F, 3.0F));
    EXPECT_FALSE(run(100, 1.001F, 3.0F));  // the reference has not moved since
}

TEST_F(AStuckCheck, WantsAReferenceThatMovesByMoreThanItsSpanInEitherDirection) {
    for (const float sign : {1.0F, -1.0F}) {
        check = StuckCheck{2.0F};
        run(1, 1.0F, 0.0F);
        EXPECT_FALSE(run(40, 1.0F, sign * 2.0F));
        EXPECT_TRUE(run(1, 1.0F, sign * 2.001F));
    }
    check = StuckCheck{2.0F};
    run(1, 1.0F, 0.0F);
    run(10, 1.0F, 1.1F);
    EXPECT_FALSE(run(9, 1.0F, -1.1F));
    EXPECT_TRUE(run(1, 1.0F, 0.0F));  // highest less lowest, wherever it is now
}

TEST_F(AStuckCheck, AllowsAReferenceItsDriftInEachCycleBeyondASecond) {
    check = StuckCheck{2.0F, 0.01F};
    run(1, 1.0F, 0.0F);
    EXPECT_FALSE(run(99, 1.0F, 1.99F));
    EXPECT_TRUE(run(1, 1.0F, 2.005F));
    EXPECT_FALSE(run(1, 1.0F, 2.005F));  // 2.01
    EXPECT_FALSE(run(99, 1.0F, 2.99F));
    EXPECT_TRUE(run(1, 1.0F, 3.015F));
    EXPECT_FALSE(run(1, 1.0F, 3.015F));
}

// Nearly three hours; from then on a float could no longer count the cycles.
TEST_F(AStuckCheck, AllowsTheDriftOfAMillionCyclesAtMost) {
    check = StuckCheck{2.0F, 0.01F};
    run(1, 1.0F, 0.0F);
    EXPECT_FALSE(run(1'100'000, 1.0F, 10'000.0F));
    EXPECT_TRUE(run(1, 1.0F, 10'002.0F));
}

TEST_F(AStuckCheck, CountsAValueThatGoesUpOrDownAsMoved) {
    for (const float moved : {1.001F, 0.999F}) {
        run(1, 1.0F, 0.0F);
        run(20, 1.0F, 3.0F);
        EXPECT_FALSE(run(1, moved, 0.0F));
        EXPECT_FALSE(run(19, moved, 3.0F));
        EXPECT_TRUE(run(1, moved, 3.0F));
    }
}

TEST_F(AStuckCheck, StartsAnewWhenEitherIsNotFinite) {
    struct Gap {
        float value;
        float reference;
    };
    for (const Gap gap : {Gap{nan, 3.0F}, Gap{infinity, 3.0F}, Gap{1.0F, nan}}) {
        run(1, 1.0F, 0.0F);
        ASSERT_TRUE(run(20, 1.0F, 3.0F));
        ASSERT_TRUE(check.seems_frozen());
        EXPECT_FALSE(run(1, gap.value, gap.reference));
        EXPECT_FALSE(check.seems_frozen());
        EXPECT_FALSE(run(19, 1.0F, 0.0F));
        EXPECT_FALSE(run(1, 1.0F, 0.0F));
    }
}

TEST_F(AStuckCheck, DoesNotJudgeWhatIsNotFinite) {
    for (const float value : {nan, infinity, -infinity}) {
        run(1, value, 0.0F);
        EXPECT_FALSE(run(100, value, 3.0F));
        EXPECT_FALSE(check.seems_frozen());
    }
}

TEST_F(AStuckCheck, SeemsFrozenFromTheSixthEqualValueOnForAnyMotionOfTheReference) {
    run(5, 1.0F, 0.0F);
    EXPECT_FALSE(check.seems_frozen());
    run(1, 1.0F, 0.0F);
    EXPECT_TRUE(check.seems_frozen());
    run(100, 1.0F, 0.0F);
    EXPECT_TRUE(check.seems_frozen());
    run(1, 1.1F, 0.0F);
    EXPECT_FALSE(check.seems_frozen());
}

// A steering wheel that says 0.1 rad all the time, while the vehicle goes straight and then turns.
class ASteeringCheck : public ::testing::Test {
 protected:
    static constexpr float angle_rad = 0.1F;

    bool run(int samples, float lateral_mps2, float yaw_acceleration_mps2, float steering_rad = angle_rad) {
        bool stuck = false;
        for (int sample = 0; sample < samples; ++sample) {
            stuck = check.is_stuck(steering_rad, lateral_mps2, yaw_acceleration_mps2);
        }
        return stuck;
    }

    // The wheel has moved in the first of these samples.
    void go_straight(int samples_since_it_moved) {
        run(1, 0.0F, 0.0F, 0.2F);
        run(1 + samples_since_it_moved, 0.0F, 0.0F);
    }

    SteeringCheck check;
};

TEST_F(ASteeringCheck, WantsBothBeyond3MetresPerSecondSquaredAndOfOneSign) {
    for (const float sign : {1.0F, -1.0F}) {
        go_straight(20);
        EXPECT_FALSE(run(10, sign * 3.0F, sign * 5.0F));
        EXPECT_FALSE(run(10, sign * 5.0F, sign * 3.0F));
        EXPECT_FALSE(run(10, sign * 5.0F, sign * -5.0F));
        EXPECT_TRUE(run(1, sign * 3.001F, sign * 5.0F));
        EXPECT_TRUE(run(1, sign * 5.0F, sign * 3.001F));
        EXPECT_FALSE(run(1, 0.0F, 0.0F));
        EXPECT_TRUE(run(1000, sign * 5.0F, sign * 5.0F));  // remembers that it went straight
    }
}

TEST_F(ASteeringCheck, WantsToHaveGoneStraightFor200MillisecondsSinceTheWheelMoved) {
    go_straight(19);
    EXPECT_FALSE(run(10, 5.0F, 5.0F));
    go_straight(20);
    EXPECT_TRUE(run(10, 5.0F, 5.0F));
}

// The way there is not known.
TEST_F(ASteeringCheck, SaysNothingInATurnInWhichItStarts) {
    EXPECT_FALSE(run(100, 5.0F, 5.0F, 0.0F));
    EXPECT_FALSE(run(100, 5.0F, 5.0F));
}

TEST_F(ASteeringCheck, WantsTheWholeStraightAfterItsStartToo) {
    run(20, 0.0F, 0.0F, 0.0F);  // the first of them repeats nothing
    EXPECT_FALSE(run(10, 5.0F, 5.0F, 0.0F));
    check = SteeringCheck{};
    run(21, 0.0F, 0.0F, 0.0F);
    EXPECT_TRUE(run(10, 5.0F, 5.0F, 0.0F));
}

TEST_F(ASteeringCheck, CallsItStraightBelow1MetrePerSecondSquared) {
    struct Motion {
        float lateral_mps2;
        float yaw_acceleration_mps2;
        bool straight;
    };
    for (const Motion motion :
         {Motion{0.999F, 0.999F, true}, Motion{-0.999F, -0.999F, true}, Motion{1.0F, 0.0F, false},
          Motion{-1.0F, 0.0F, false}, Motion{0.0F, 1.0F, false}, Motion{0.0F, -1.0F, false}}) {
        go_straight(10);
        run(10, motion.lateral_mps2, motion.yaw_acceleration_mps2);
        EXPECT_EQ(run(1, 5.0F, 5.0F), motion.straight);
    }
}

TEST_F(ASteeringCheck, WantsTheStraightWithoutABreak) {
    go_straight(10);
    run(1, 1.5F, 1.5F);
    run(19, 0.0F, 0.0F);
    EXPECT_FALSE(run(1, 5.0F, 5.0F));
    run(20, 0.0F, 0.0F);
    EXPECT_TRUE(run(1, 5.0F, 5.0F));
}

TEST_F(ASteeringCheck, AcceptsAWheelThatMoves) {
    for (const float moved_rad : {0.101F, 0.099F}) {
        go_straight(20);
        ASSERT_TRUE(run(1, 5.0F, 5.0F));
        EXPECT_FALSE(run(1, 5.0F, 5.0F, moved_rad));
        EXPECT_FALSE(run(100, 5.0F, 5.0F, moved_rad));
    }
}

TEST_F(ASteeringCheck, StartsAnewWhenASampleIsNotFinite) {
    struct Gap {
        float steering_rad;
        float lateral_mps2;
        float yaw_acceleration_mps2;
    };
    for (const Gap gap : {Gap{nan, 0.0F, 0.0F}, Gap{infinity, 0.0F, 0.0F}, Gap{angle_rad, nan, 0.0F},
                          Gap{angle_rad, 0.0F, nan}}) {
        go_straight(20);
        EXPECT_FALSE(run(1, gap.lateral_mps2, gap.yaw_acceleration_mps2, gap.steering_rad));
        EXPECT_FALSE(run(10, 5.0F, 5.0F));
    }
}

}  // namespace
}  // namespace monitoring_stuck_test
