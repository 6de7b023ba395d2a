// An accelerometer that is wrong by a factor, against what yaw rate and roll motion say of the same force.
#include <gtest/gtest.h>

#include "rsi/ecu/monitoring/force_gain.hpp"

namespace monitoring_force_gain_test {
namespace {

class AForceGain : public ::testing::Test {
 protected:
    void turn(int samples, float shown_mps2, float by_yaw_mps2, float by_roll_mps2, bool tipping = false) {
        for (int sample = 0; sample < samples; ++sample) {
            gain.update({shown_mps2, shown_mps2, by_yaw_mps2, by_roll_mps2}, tipping);
        }
    }

    // Turns of 0.2 g, a second to each side, as a sensor with this gain shows them.
    void drive(float share, int turns, float seconds = 1.0F) {
        for (int number = 0; number < turns; ++number) {
            const float force = (number % 2 == 0) ? 2.0F : -2.0F;
            turn(static_cast<int>(100.0F * seconds), share * force, force, force);
        }
    }

    struct Turn {
        float shown_mps2;
        float by_yaw_mps2;
        float by_roll_mps2;
    };

    // To either side: five samples of the one do not set the code, nor do four of the other, but five
    // do.
    void expect_code_at_once_between(const Turn& admitted, const Turn& with_code) {
        for (const float side : {1.0F, -1.0F}) {
            gain = {};
            turn(5, side * admitted.shown_mps2, side * admitted.by_yaw_mps2, side * admitted.by_roll_mps2);
            EXPECT_FALSE(gain.is_wrong());
            turn(4, side * with_code.shown_mps2, side * with_code.by_yaw_mps2, side * with_code.by_roll_mps2);
            EXPECT_FALSE(gain.is_wrong());
            turn(1, side * with_code.shown_mps2, side * with_code.by_yaw_mps2, side * with_code.by_roll_mps2);
            EXPECT_TRUE(gain.is_wrong());
        }
    }

    rsi::monitoring::ForceGain gain;
};

TEST_F(AForceGain, FindsHalfOfTheForceInASecondOfTurningAt2MetresPerSecondSquaredToEachSide) {
    drive(0.5F, 2, 0.79F);  // 0.5 m/s^2 beyond
    EXPECT_FALSE(gain.is_wrong());
    drive(0.5F, 2, 0.02F);
    EXPECT_TRUE(gain.is_wrong());
}

TEST_F(AForceGain, FindsThreeQuartersTooMuchInLessThanTwoSecondsOfTurningToEachSide) {
    drive(1.75F, 2, 1.32F);  // 0.3 m/s^2 beyond
    EXPECT_FALSE(gain.is_wrong());
    drive(1.75F, 2, 0.03F);
    EXPECT_TRUE(gain.is_wrong());
}

TEST_F(AForceGain, FindsNoiseWithoutASignal) {
    drive(0.0F, 2, 0.28F);
    EXPECT_TRUE(gain.is_wrong());
}

TEST_F(AForceGain, AdmitsWhatLoadsAndRoadsMakeOfAGoodSensor) {
    drive(0.76F, 100);
    drive(1.59F, 100);
    EXPECT_FALSE(gain.is_wrong());
}

// As a turn ends the yaw rate is ahead of the force.
TEST_F(AForceGain, RemembersATurnWhoseEndLooksRight) {
    for (int number = 0; number < 2; ++number) {
        const float side = (number % 2 == 0) ? 1.0F : -1.0F;
        turn(300, side * 1.0F, side * 2.0F, side * 2.0F);
        turn(20, side * 1.1F, side * 1.1F, side * 1.8F);
    }
    EXPECT_TRUE(gain.is_wrong());
}

TEST_F(AForceGain, BeginsAtThreeQuartersAndAt160PerCent) {
    drive(0.74F, 100);
    EXPECT_TRUE(gain.is_wrong());
    gain = {};
    drive(1.61F, 100);
    EXPECT_TRUE(gain.is_wrong());
}

// The body rolls twice as far; the yaw rate stands by the accelerometer. And half as far, emptied.
TEST_F(AForceGain, AdmitsALoadOfAnySize) {
    for (const float load : {2.0F, 0.5F}) {
        for (int number = 0; number < 100; ++number) {
            const float force = (number % 2 == 0) ? 4.0F : -4.0F;
            turn(100, force, force, load * force);
        }
        EXPECT_FALSE(gain.is_wrong());
    }
}

// Accelerometer and body feel what the bank leaves of the turn.
TEST_F(AForceGain, AdmitsCurvesThatLeanInwardsOrOutwards) {
    for (const float left : {0.4F, 2.0F}) {
        for (int number = 0; number < 100; ++number) {
            const float turns = (number % 2 == 0) ? 4.0F : -4.0F;
            turn(100, left * turns, turns, left * turns);
        }
        EXPECT_FALSE(gain.is_wrong());
    }
}

// On a motorway whose curves lean inwards by 0.75 m/s^2, with a roll angle that is off by 1 deg.
TEST_F(AForceGain, AdmitsAnOffsetOfTheRollAngle) {
    for (int number = 0; number < 100; ++number) {
        const float side = (number % 2 == 0) ? 1.0F : -1.0F;
        turn(100, side * 0.75F, side * 1.5F, side * 0.75F + 1.2F);
    }
    EXPECT_FALSE(gain.is_wrong());
}

TEST_F(AForceGain, NeedsTurnsToBothSides) {
    for (const float side : {1.0F, -1.0F}) {
        gain = {};
        turn(1000, side * 1.0F, side * 2.0F, side * 2.0F);
        turn(1000, side * 4.0F, side * 2.4F, side * 2.4F);
        EXPECT_FALSE(gain.is_wrong());
    }
}

TEST_F(AForceGain, NeedsBothReferencesBeyond1MetrePerSecondSquaredOnOneSide) {
    for (const float small : {0.99F, -2.0F}) {
        for (int number = 0; number < 100; ++number) {
            const float side = (number % 2 == 0) ? 1.0F : -1.0F;
            turn(100, 0.0F, side * 2.0F, side * small);
            turn(100, 0.0F, side * small, side * 2.0F);
        }
        EXPECT_FALSE(gain.is_wrong());
    }
    for (int number = 0; number < 2; ++number) {
        const float side = (number % 2 == 0) ? 1.0F : -1.0F;
        turn(100, 0.0F, side * 1.01F, side * 1.01F);
    }
    EXPECT_TRUE(gain.is_wrong());
}

// A load of 70 % under which the vehicle slides stays below it.
TEST_F(AForceGain, NeedsNoSecondTurnForLessThan58PerCentAndMoreThan1500MillimetresPerSecondSquared) {
    const Turn by_586_per_mille{2.93F, 5.0F, 6.0F};
    const Turn by_574_per_mille{2.87F, 5.0F, 6.0F};
    expect_code_at_once_between(by_586_per_mille, by_574_per_mille);
    const Turn by_1490_mmps2{1.51F, 3.0F, 3.0F};
    const Turn by_1520_mmps2{1.48F, 3.0F, 3.0F};
    expect_code_at_once_between(by_1490_mmps2, by_1520_mmps2);
}

TEST_F(AForceGain, NeedsNoSecondTurnForMoreThan180PerCentAndMoreThan1500MillimetresPerSecondSquared) {
    const Turn by_178_per_cent{7.12F, 3.0F, 4.0F};
    const Turn by_181_per_cent{7.24F, 3.0F, 4.0F};
    expect_code_at_once_between(by_178_per_cent, by_181_per_cent);
    const Turn by_1490_mmps2{3.29F, 1.8F, 1.8F};
    const Turn by_1520_mmps2{3.32F, 1.8F, 1.8F};
    expect_code_at_once_between(by_1490_mmps2, by_1520_mmps2);
}

TEST_F(AForceGain, TakesNoFourSamplesForFive) {
    turn(4, 2.0F, 5.0F, 5.0F);
    EXPECT_FALSE(gain.is_wrong());
    turn(20, 5.0F, 5.0F, 5.0F);
    for (int times = 0; times < 10; ++times) {
        turn(4, 2.0F, 5.0F, 5.0F);
        turn(20, 5.0F, 5.0F, 5.0F);
    }
    EXPECT_FALSE(gain.is_wrong());
}

// It shows what the force was 80 ms ago.
TEST_F(AForceGain, AdmitsALateSensorWhileTheForceGrowsOrFades) {
    for (const float side : {1.0F, -1.0F}) {
        for (int sample = 0; sample < 100; ++sample) {
            gain.update({side * 2.3F, side * 3.9F, side * 5.0F, side * 5.0F}, false);
            EXPECT_FALSE(gain.is_wrong());
        }
        for (int sample = 0; sample < 100; ++sample) {
            gain.update({side * 6.0F, side * 3.1F, side * 2.0F, side * 2.0F}, false);
            EXPECT_FALSE(gain.is_wrong());
        }
        for (int sample = 0; sample < 100; ++sample) {
            gain.update({side * 3.9F, side * 2.3F, side * 5.0F, side * 5.0F}, false);
            EXPECT_FALSE(gain.is_wrong());
        }
        for (int sample = 0; sample < 100; ++sample) {
            gain.update({side * 3.1F, side * 6.0F, side * 2.0F, side * 2.0F}, false);
            EXPECT_FALSE(gain.is_wrong());
        }
    }
}

// However long it lasts: neither what was right nor what was wrong is held for longer than a turn.
TEST_F(AForceGain, ForgetsHowLongItWasRightOrWrong) {
    drive(1.0F, 100);
    drive(0.5F, 2, 0.82F);
    EXPECT_TRUE(gain.is_wrong());
    drive(0.5F, 100);
    turn(101, 2.0F, 2.0F, 2.0F);
    EXPECT_FALSE(gain.is_wrong());
}

// A body that tips over needs no force to roll further; too strong is too strong even then.
TEST_F(AForceGain, IsNotTooWeakWhileTheInnerWheelsMayBeInTheAir) {
    for (int number = 0; number < 10; ++number) {
        const float side = (number % 2 == 0) ? 1.0F : -1.0F;
        turn(100, side * 3.0F, side * 6.0F, side * 6.0F, true);
    }
    EXPECT_FALSE(gain.is_wrong());
    turn(5, 12.0F, 6.0F, 6.0F, true);
    EXPECT_TRUE(gain.is_wrong());
}

TEST_F(AForceGain, StaysWrongThroughTurnsThatShowIt) {
    turn(5, 2.0F, 5.0F, 5.0F);
    drive(0.5F, 100);
    EXPECT_TRUE(gain.is_wrong());
}

TEST_F(AForceGain, IsAcceptedAfterEightSecondsOfCalmStraights) {
    for (const float shown : {2.0F, 10.0F}) {
        gain = {};
        turn(5, shown, 5.0F, 5.0F);
        turn(799, 0.99F, -0.99F, 0.0F);
        EXPECT_TRUE(gain.is_wrong());
        turn(1, -0.99F, 0.99F, 0.0F);
        EXPECT_FALSE(gain.is_wrong());
    }
}

// It is noise that shows a force where there is none; a contradiction between the references shows nothing.
TEST_F(AForceGain, IsAcceptedOnlyIfTheWholeOfThatWasCalm) {
    turn(799, 0.0F, 0.0F, 0.0F);
    turn(5, 2.0F, 5.0F, 5.0F);
    turn(799, 0.0F, 0.0F, 0.0F);
    EXPECT_TRUE(gain.is_wrong());
    turn(1, 1.01F, 0.0F, 0.0F);
    EXPECT_TRUE(gain.is_wrong());
    turn(799, 0.0F, 0.0F, 0.0F);
    turn(100, 0.0F, 1.01F, 0.0F);
    drive(0.5F, 2);
    EXPECT_TRUE(gain.is_wrong());
    turn(1, 0.0F, 0.0F, 0.0F);
    EXPECT_FALSE(gain.is_wrong());
    turn(5, 2.0F, 5.0F, 5.0F);
    turn(799, 0.0F, 0.0F, 0.0F);
    EXPECT_TRUE(gain.is_wrong());
    turn(1, 0.0F, 0.0F, 0.0F);
    EXPECT_FALSE(gain.is_wrong());
}

// Half of the force again, a moment to each side; not so one that shows it.
TEST_F(AForceGain, NeedsLittleToBeWrongAgain) {
    for (const float share : {0.5F, 1.75F}) {
        gain = {};
        drive(share, 2, 2.0F);
        turn(800, 0.0F, 0.0F, 0.0F);
        drive(share, 1, 1.0F);
        EXPECT_FALSE(gain.is_wrong());
        drive(share, 2, 0.01F);
        EXPECT_TRUE(gain.is_wrong());
        turn(800, 0.0F, 0.0F, 0.0F);
        turn(100, -2.0F * share, -2.0F, -2.0F);
        EXPECT_FALSE(gain.is_wrong());
        gain = {};
        drive(share, 2, 2.0F);
        turn(800, 0.0F, 0.0F, 0.0F);
        drive(1.0F, 2);
        drive(share, 2, 0.5F);
        EXPECT_FALSE(gain.is_wrong());
    }
}

// A sensor without a symptom has no code.
TEST_F(AForceGain, ThatWasTooWeakIsNotOnProbationForTooStrong) {
    turn(5, 2.0F, 5.0F, 5.0F);
    turn(800, 0.0F, 0.0F, 0.0F);
    drive(1.75F, 2, 0.5F);
    EXPECT_FALSE(gain.is_wrong());
}

// 0.5 m/s, of which a turn of 2 m/s^2 takes 0.5 m/s^2 back.
TEST_F(AForceGain, IsRightAgainAfterASecondOfARightTurnToEitherSide) {
    for (const float side : {1.0F, -1.0F}) {
        gain = {};
        turn(5, 2.0F, 5.0F, 5.0F);
        turn(98, side * 2.0F, side * 2.0F, side * 2.0F);
        EXPECT_TRUE(gain.is_wrong());
        turn(3, side * 2.0F, side * 2.0F, side * 2.0F);
        EXPECT_FALSE(gain.is_wrong());
    }
}

}  // namespace
}  // namespace monitoring_force_gain_test
