// The checks of one sensor against another: at, just below and just above their limits, and what they forget.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rsi/ecu/monitoring/force_vote.hpp"
#include "rsi/ecu/monitoring/inclination.hpp"
#include "rsi/ecu/monitoring/roll_consistency.hpp"
#include "rsi/ecu/monitoring/turn_consistency.hpp"
#include "rsi/ecu/monitoring/vertical_offset.hpp"
#include "tests/monitoring/leaning_body.hpp"
#include "tests/support/large_suv.h"

namespace monitoring_consistency_test {
namespace {

using rsi::monitoring::ForceVote;
using rsi::monitoring::RollConsistency;
using rsi::monitoring::TurnConsistency;
using rsi::monitoring::VerticalOffset;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float gravity = 9.80665F;

// A roll angle that goes its way while the roll rate says something else.
class ARollAngle : public ::testing::Test {
 protected:
    void run(int samples, float rise_per_sample, float roll_rate_radps = 0.0F) {
        for (int sample = 0; sample < samples; ++sample) {
            angle_rad += rise_per_sample;
            check.update(angle_rad, roll_rate_radps, inclination_rad);
        }
    }

    RollConsistency check;
    float angle_rad{0.0F};
    float inclination_rad{nan};
};

TEST_F(ARollAngle, IsJudgedFromThe21stSampleOn) {
    run(20, 0.03F);
    EXPECT_FALSE(check.known());
    EXPECT_FALSE(check.contradicts(false));
    run(1, 0.03F);
    EXPECT_TRUE(check.known());
    EXPECT_TRUE(check.contradicts(false));
}

TEST_F(ARollAngle, ContradictsWhenItComesApartBy3Point5DegreesIn200Milliseconds) {
    for (const float sign : {1.0F, -1.0F}) {
        check = RollConsistency{};
        run(90, sign * 0.0030F);
        EXPECT_FALSE(check.contradicts(false));
        run(30, sign * 0.0031F);
        EXPECT_TRUE(check.contradicts(false));
        run(30, 0.0F);
        EXPECT_FALSE(check.contradicts(false));
    }
}

TEST_F(ARollAngle, HasAnOffsetWhenItComesApartBy9DegreesInASecond) {
    for (const float sign : {1.0F, -1.0F}) {
        check = RollConsistency{};
        run(150, sign * 0.00155F);
        EXPECT_FALSE(check.has_offset(false));
        run(110, sign * 0.00160F);
        EXPECT_TRUE(check.has_offset(false));
        EXPECT_FALSE(check.contradicts(false));
    }
}

TEST_F(ARollAngle, HasNoOffsetBeforeASecondIsOver) {
    run(100, 0.0025F);
    EXPECT_TRUE(check.known());
    EXPECT_FALSE(check.has_offset(false));
    run(1, 0.0025F);
    EXPECT_TRUE(check.has_offset(false));
}

TEST_F(ARollAngle, AgreesWithTheRateThatTurnsItAndNotWithOneThatDoesNot) {
    run(200, 0.005F, 0.5F);
    EXPECT_FALSE(check.contradicts(false));
    EXPECT_FALSE(check.has_offset(false));
    run(30, 0.0F, 0.5F);
    EXPECT_TRUE(check.contradicts(false));
}

// Findings before a gap do not count after it.
TEST_F(ARollAngle, StartsAnewAfterASampleThatIsNotFinite) {
    for (const bool of_angle : {true, false}) {
        for (const float bad : {nan, infinity}) {
            run(150, 0.004F);
            ASSERT_TRUE(check.contradicts(false));
            ASSERT_TRUE(check.has_offset(false));
            check.update(of_angle ? bad : angle_rad, of_angle ? 0.0F : bad, inclination_rad);
            EXPECT_FALSE(check.known());
            EXPECT_FALSE(check.contradicts(false));
            EXPECT_FALSE(check.has_offset(false));
            run(20, 0.0F);
            EXPECT_FALSE(check.known());
            run(1, 0.0F);
            EXPECT_TRUE(check.known());
            EXPECT_FALSE(check.contradicts(false));
            EXPECT_FALSE(check.has_offset(false));
        }
    }
}

// The integral of a rate with an offset must not grow until it has lost its resolution.
TEST_F(ARollAngle, StartsAnewWhenTheIntegralOfTheRateComesTo50Radians) {
    run(990, 0.05F, 5.0F);
    EXPECT_TRUE(check.known());
    int unknown_samples = 0;
    for (int sample = 0; sample < 50; ++sample) {
        run(1, 0.05F, 5.0F);
        unknown_samples += check.known() ? 0 : 1;
        EXPECT_FALSE(check.contradicts(false));
    }
    EXPECT_EQ(unknown_samples, 21);
    EXPECT_TRUE(check.known());
}

// A road that turns the whole body without its rolling against the road.
class ATwistingRoad : public ::testing::Test {
 protected:
    struct Said {
        bool contradicts{false};
        bool has_offset{false};
    };

    // Level for 1 s, then `rate_radps` for `twist_s`, then level again for 1 s; `seen` of it by the
    // accelerometer.
    static Said drive(float rate_radps, float twist_s, float seen, bool may_twist) {
        RollConsistency check;
        Said said;
        float inclination_rad = 0.0F;
        const int twist_samples = static_cast<int>(100.0F * twist_s + 0.5F);
        for (int sample = 0; sample < 200 + twist_samples; ++sample) {
            const bool twists = sample >= 100 && sample < 100 + twist_samples;
            const float rate = twists ? rate_radps : 0.0F;
            inclination_rad += 0.01F * rate;
            check.update(0.0F, rate, seen * inclination_rad);
            said.contradicts = said.contradicts || check.contradicts(may_twist);
            said.has_offset = said.has_offset || check.has_offset(may_twist);
        }
        return said;
    }
};

TEST_F(ATwistingRoad, IsNoContradictionWhereTheAccelerometerSeesIt) {
    for (const float side : {1.0F, -1.0F}) {
        for (const float rate_radps : {0.2F, 0.4F}) {  // 12 deg in a second; 4.6 deg in 0.2 s
            const Said said = drive(side * rate_radps, 1.0F, 1.0F, true);
            EXPECT_FALSE(said.contradicts) << rate_radps;
            EXPECT_FALSE(said.has_offset) << rate_radps;
        }
    }
}

TEST_F(ATwistingRoad, IsOneWhereTheAccelerometerDoesNotSeeItOrTheBodyDoesNotRollAsForced) {
    for (const Said& said :
         {drive(0.4F, 1.0F, 0.0F, true), drive(0.4F, 1.0F, 1.0F, false), drive(0.4F, 1.0F, nan, true)}) {
        EXPECT_TRUE(said.contradicts);
        EXPECT_TRUE(said.has_offset);
    }
}

// 9 deg more than what the roll rate says, within a second, or 3.5 deg within 0.2 s: limits as for the angle.
TEST_F(ATwistingRoad, MustBeSeenWithinTheSameLimits) {
    EXPECT_FALSE(drive(0.2F, 1.0F, 0.3F, true).has_offset);
    EXPECT_TRUE(drive(0.2F, 1.0F, 0.1F, true).has_offset);
    EXPECT_FALSE(drive(0.5F, 0.2F, 0.6F, true).contradicts);
    EXPECT_TRUE(drive(0.5F, 0.2F, 0.1F, true).contradicts);
}

// 50 ms smooth the accelerometer's noise.
TEST_F(ATwistingRoad, TakesTheInclinationThroughALagOf50MillisecondsButForItsFirst) {
    RollConsistency check;
    for (int sample = 0; sample < 100; ++sample) {
        check.update(0.0F, 0.0F, 0.3F);
    }
    // The angle moves and with it nothing else: a fifth of a step of 0.3 rad is within the limit of 0.061
    // rad.
    check.update(0.07F, 0.0F, 0.6F);
    EXPECT_FALSE(check.contradicts(true));
    EXPECT_TRUE(check.contradicts(false));
    check.update(0.07F, 0.0F, 0.6F);
    EXPECT_TRUE(check.contradicts(true));
    // One of 0.31 rad is beyond it.
    check = RollConsistency{};
    for (int sample = 0; sample < 100; ++sample) {
        check.update(0.0F, 0.0F, 0.3F);
    }
    check.update(0.07F, 0.0F, 0.61F);
    EXPECT_TRUE(check.contradicts(true));
}

// Nor does a lag have to settle first: neither from nothing, nor from where the body was before a gap.
TEST_F(ATwistingRoad, DoesNotTwistByWhatTheBodyIsInclinedByFromTheStart) {
    RollConsistency check;
    for (const float inclination_rad : {0.7F, -0.7F}) {
        for (int sample = 0; sample < 20; ++sample) {
            check.update(0.0F, 0.0F, inclination_rad);
        }
        check.update(0.07F, 0.0F, inclination_rad);
        EXPECT_TRUE(check.contradicts(false));
        EXPECT_FALSE(check.contradicts(true));
        check.update(nan, 0.0F, inclination_rad);
    }
}

// Lateral acceleration against yaw rate times speed.
class ATurn : public ::testing::Test {
 protected:
    static constexpr float speed_mps = 20.0F;

    void run(int samples, float lateral_mps2, float yaw_acceleration_mps2) {
        for (int sample = 0; sample < samples; ++sample) {
            check.update(lateral_mps2, yaw_acceleration_mps2 / speed_mps, speed_mps, true);
        }
    }

    void expect_no_code() const {
        EXPECT_FALSE(check.known());
        EXPECT_FALSE(check.suspicious());
        EXPECT_FALSE(check.contradicts());
    }

    void expect_no_statement() const {
        expect_no_code();
        EXPECT_FALSE(check.agrees());
    }

    TurnConsistency check;
};

TEST_F(ATurn, IsNotJudgedBeforeItsFirstSample) {
    expect_no_statement();
    EXPECT_FALSE(check.spins());
}

TEST_F(ATurn, SetsNoCodeUpTo5MetresASecond) {
    check.update(1.0F, 0.1F, 5.0F, true);
    expect_no_code();
    EXPECT_TRUE(check.agrees());
    check.update(3.0F, 0.1F, 5.0F, true);
    EXPECT_FALSE(check.agrees());
    check.update(1.0F, 0.1F, 5.001F, true);
    EXPECT_TRUE(check.known());
    EXPECT_TRUE(check.agrees());
}

TEST_F(ATurn, SetsNoCodeWhileItMayGoBackwards) {
    check.update(5.0F, -0.25F, speed_mps, false);
    expect_no_code();
    check.update(5.0F, -0.25F, speed_mps, true);
    EXPECT_TRUE(check.known());
}

TEST_F(ATurn, IsSuspiciousWhenTheFastFilterExceedsTheBankOfARoad) {
    for (const float sign : {1.0F, -1.0F}) {
        check = TurnConsistency{};
        run(300, sign * 5.49F, sign * 4.0F);
        EXPECT_FALSE(check.suspicious());
        check = TurnConsistency{};
        run(20, sign * 3.0F, 0.0F);  // of lag 0.3 s: half of the step after 0.21 s
        EXPECT_FALSE(check.suspicious());
        run(1, sign * 3.0F, 0.0F);
        EXPECT_TRUE(check.suspicious());
        EXPECT_FALSE(check.contradicts());
    }
}

TEST_F(ATurn, ContradictsWhenTheSlowFilterExceedsAnySlide) {
    for (const float sign : {1.0F, -1.0F}) {
        check = TurnConsistency{};
        run(4000, sign * 6.9F, 0.0F);
        EXPECT_FALSE(check.contradicts());
        check = TurnConsistency{};
        run(825, 0.0F, sign * 8.0F);  // of lag 4 s: seven eighths of the step after 8.3 s
        EXPECT_FALSE(check.contradicts());
        run(12, 0.0F, sign * 8.0F);
        EXPECT_TRUE(check.contradicts());
    }
}

TEST_F(ATurn, AgreesUpTo2MetresPerSecondSquared) {
    for (const float sign : {1.0F, -1.0F}) {
        run(1, sign * 5.99F, sign * 4.0F);
        EXPECT_TRUE(check.agrees());
        run(1, sign * 6.01F, sign * 4.0F);
        EXPECT_FALSE(check.agrees());
    }
}

TEST_F(ATurn, StartsAnewWhenTheVehicleHardlyMovesOrASampleIsNotFinite) {
    struct Gap {
        float lateral;
        float yaw_rate;
        float speed;
    };
    for (const Gap gap : {Gap{9.0F, 0.0F, 4.0F}, Gap{nan, 0.0F, 20.0F}, Gap{9.0F, nan, 20.0F},
                          Gap{9.0F, 0.0F, nan}, Gap{9.0F, 0.0F, infinity}}) {
        run(1500, 9.0F, 0.0F);
        ASSERT_TRUE(check.suspicious());
        ASSERT_TRUE(check.contradicts());
        check.update(gap.lateral, gap.yaw_rate, gap.speed, true);
        expect_no_statement();
        run(1, 9.0F, 0.0F);
        EXPECT_TRUE(check.known());
        EXPECT_FALSE(check.suspicious());
        EXPECT_FALSE(check.contradicts());
    }
}

TEST_F(ATurn, TakesAsLongToBeSuspiciousAfterAGapAsFromTheStart) {
    for (const float sign : {1.0F, -1.0F}) {
        check.update(nan, 0.0F, speed_mps, true);
        run(20, sign * 3.0F, 0.0F);
        EXPECT_FALSE(check.suspicious());
        run(1, sign * 3.0F, 0.0F);
        EXPECT_TRUE(check.suspicious());
    }
}

TEST_F(ATurn, TakesAsLongToContradictAfterAGapAsFromTheStart) {
    for (const float sign : {1.0F, -1.0F}) {
        check.update(nan, 0.0F, speed_mps, true);
        run(825, 0.0F, sign * 8.0F);
        EXPECT_FALSE(check.contradicts());
        run(12, 0.0F, sign * 8.0F);
        EXPECT_TRUE(check.contradicts());
    }
}

TEST_F(ATurn, SpinsForASecondAfterItHasYawedFasterThanTyresTurn) {
    for (const float sign : {1.0F, -1.0F}) {
        run(200, sign * 10.4F, sign * 10.4F);
        EXPECT_FALSE(check.spins());
        run(1, sign * 10.4F, sign * 10.6F);
        EXPECT_TRUE(check.spins());
        run(99, 0.0F, 0.0F);
        EXPECT_TRUE(check.spins());
        run(1, 0.0F, 0.0F);
        EXPECT_FALSE(check.spins());
    }
}

TEST_F(ATurn, DoesNotSpinByWhatIsNotKnown) {
    check.update(0.0F, 4.0F, 4.0F, true);
    EXPECT_FALSE(check.spins());
    check.update(nan, 1.0F, 20.0F, true);
    EXPECT_FALSE(check.spins());
}

// The vertical force of a body that neither rises nor falls.
class AVerticalForce : public ::testing::Test {
 protected:
    void run(int samples, float vertical_mps2, float lateral_mps2 = 0.0F, float roll_angle_rad = 0.0F) {
        for (int sample = 0; sample < samples; ++sample) {
            check.update(vertical_mps2, lateral_mps2, roll_angle_rad, turn_mps2, bank_rad);
        }
    }

    VerticalOffset check;
    float turn_mps2{0.0F};
    float bank_rad{0.0F};
};

TEST_F(AVerticalForce, HasAnOffsetBeyondItsLimitAndBeyondALargerOneInAWarning) {
    for (const float sign : {1.0F, -1.0F}) {
        check = VerticalOffset{};
        run(1000, gravity + sign * 1.49F);
        EXPECT_TRUE(check.is_within());
        EXPECT_FALSE(check.is_beyond(false));
        run(1000, gravity + sign * 1.51F);
        EXPECT_FALSE(check.is_within());
        EXPECT_TRUE(check.is_beyond(false));
        run(1000, gravity + sign * 3.49F);
        EXPECT_TRUE(check.is_beyond(false));
        EXPECT_FALSE(check.is_beyond(true));
        run(1000, gravity + sign * 3.51F);
        EXPECT_TRUE(check.is_beyond(true));
    }
}

TEST_F(AVerticalForce, IsJudgedByItsMeanOver400Milliseconds) {
    run(27, gravity + 3.0F);
    EXPECT_FALSE(check.is_beyond(false));
    run(1, gravity + 3.0F);
    EXPECT_TRUE(check.is_beyond(false));
}

TEST_F(AVerticalForce, IsJudgedByItsMeanOver400MillisecondsAfterAGapToo) {
    for (const float sign : {1.0F, -1.0F}) {
        run(1, nan);
        run(27, gravity + sign * 3.0F);
        EXPECT_FALSE(check.is_beyond(false));
        run(1, gravity + sign * 3.0F);
        EXPECT_TRUE(check.is_beyond(false));
    }
}

TEST_F(AVerticalForce, IsJudgedWhileTheBodyIsUpright) {
    for (const float sign : {1.0F, -1.0F}) {
        run(1, gravity, sign * 11.0F, 0.0F);
        EXPECT_TRUE(check.is_within());
        run(1, gravity, 0.0F, sign * 0.2F);
        EXPECT_TRUE(check.is_within());
    }
}

TEST_F(AVerticalForce, IsSmallerInABodyThatLeansOutOfTheTurn) {
    run(1000, gravity - 10.0F * 0.19F, 10.0F, 0.19F);
    EXPECT_TRUE(check.is_within());
    EXPECT_FALSE(check.is_beyond(false));
    run(1000, gravity, 10.0F, 0.19F);
    EXPECT_TRUE(check.is_beyond(false));
}

// Turn of 5 m/s^2 on a road that leans into it by 0.4 rad.
TEST_F(AVerticalForce, IsLargerOnARoadThatLeansIntoTheTurnByAnyPartOfIt) {
    for (const float sign : {1.0F, -1.0F}) {
        check = VerticalOffset{};
        turn_mps2 = sign * 5.0F;
        bank_rad = sign * -0.4F;
        run(1000, gravity + 3.49F);
        EXPECT_FALSE(check.is_beyond(false));
        run(1000, gravity - 1.49F);
        EXPECT_FALSE(check.is_beyond(false));
        run(1000, gravity - 1.51F);
        EXPECT_TRUE(check.is_beyond(false));
        run(1000, gravity + 3.51F);
        EXPECT_TRUE(check.is_beyond(false));
        bank_rad = -bank_rad;  // out of it
        run(1000, gravity + 1.51F);
        EXPECT_TRUE(check.is_beyond(false));
        bank_rad = nan;  // as if there were none
        run(1000, gravity + 1.49F);
        EXPECT_TRUE(check.is_within());
    }
}

TEST_F(AVerticalForce, IsNotJudgedBeforeItsFirstSample) {
    EXPECT_FALSE(check.is_within());
    EXPECT_FALSE(check.is_beyond(false));
}

TEST_F(AVerticalForce, StartsAnewWhereItIsNotKnown) {
    struct Gap {
        float vertical;
        float lateral;
        float roll_angle;
    };
    const float high = gravity + 4.0F;
    for (const Gap gap :
         {Gap{nan, 0.0F, 0.0F}, Gap{infinity, 0.0F, 0.0F}, Gap{high, nan, 0.0F}, Gap{high, 0.0F, nan},
          Gap{high, 0.0F, 0.21F}, Gap{high, 0.0F, -0.21F}, Gap{high, 11.1F, 0.0F}, Gap{high, -11.1F, 0.0F}}) {
        run(1000, high);
        ASSERT_TRUE(check.is_beyond(true));
        run(1, gap.vertical, gap.lateral, gap.roll_angle);
        EXPECT_FALSE(check.is_within());
        EXPECT_FALSE(check.is_beyond(false));
        run(1, high);
        EXPECT_TRUE(check.is_within());
        EXPECT_FALSE(check.is_beyond(false));
    }
}

TEST(AnInclination, IsTheArcSineOfWhatTheForceIsMoreThanTheTurnNeeds) {
    for (const float sign : {1.0F, -1.0F}) {
        EXPECT_NEAR(rsi::monitoring::inclination_rad(sign * (2.0F + 0.3F * gravity), sign * 2.0F),
                    sign * std::asin(0.3F), 2e-4F);
        EXPECT_NEAR(rsi::monitoring::inclination_rad(sign * 0.59F * gravity, 0.0F),
                    sign * 0.59F * 1.05801667F, 1e-6F);
        EXPECT_TRUE(std::isnan(rsi::monitoring::inclination_rad(sign * 0.61F * gravity, 0.0F)));
    }
    EXPECT_TRUE(std::isnan(rsi::monitoring::inclination_rad(nan, 0.0F)));
}

// As ForceVote takes it: at 20 m/s the yaw rate is given by what it says of the lateral acceleration.
rsi::Inputs sample_of(float accelerometer_mps2, float by_yaw_mps2, float roll_angle_rad,
                      float roll_rate_radps = 0.0F) {
    rsi::Inputs inputs{};
    inputs.lateral_specific_force_mps2 = accelerometer_mps2;
    inputs.speed_mps = 20.0F;
    inputs.yaw_rate_radps = by_yaw_mps2 / inputs.speed_mps;
    inputs.roll_angle_rad = roll_angle_rad;
    inputs.roll_rate_radps = roll_rate_radps;
    return inputs;
}

// One sample of a sensor whose angle is against the road, going forwards.
void feed(rsi::monitoring::ForceVote& vote, const rsi::Inputs& inputs) {
    vote.update(inputs, inputs.roll_angle_rad, true);
}

// Three estimates of the lateral force; the roll angle is given as the force under which the body takes it.
class AForceVote : public ::testing::Test {
 protected:
    void SetUp() override { vote.start(parameters()); }

    static rsi::Parameters parameters() { return rsi_test_large_suv(); }

    static float roll_angle_rad(float force_mps2) {
        return monitoring_test::held_roll_angle_rad(parameters(), force_mps2);
    }

    bool alone_after(int samples, float accelerometer_mps2, float by_yaw_mps2, float by_roll_mps2) {
        for (int sample = 0; sample < samples; ++sample) {
            feed(vote, sample_of(accelerometer_mps2, by_yaw_mps2, roll_angle_rad(by_roll_mps2)));
        }
        return vote.accelerometer_is_alone();
    }

    ForceVote vote;
};

TEST_F(AForceVote, IsAgainstAnAccelerometerThatBothOthersContradict) {
    for (const float sign : {1.0F, -1.0F}) {
        EXPECT_FALSE(alone_after(300, sign * 5.9F, sign * 3.0F, sign * 3.0F));
        EXPECT_TRUE(alone_after(300, sign * 6.1F, sign * 3.0F, sign * 3.0F));
    }
}

TEST_F(AForceVote, TakesAMeanOver300Milliseconds) {
    EXPECT_FALSE(alone_after(10, 10.0F, 0.0F, 0.0F));
    EXPECT_TRUE(alone_after(1, 10.0F, 0.0F, 0.0F));
}

// The body of a vehicle that is loaded so rolls under the same force as much further; an impossible load is
// not used, and the known one stays.
TEST_F(AForceVote, TakesTheForceOfTheLoadedBody) {
    struct Load {
        float excess;
        float force_mps2;  // that rolls the loaded body as 4 m/s^2 would roll the calibrated one
    };
    rsi::Parameters suv = parameters();
    suv.load_adaptation = 1.0F;
    for (const Load& load : {Load{1.0F, 2.0F}, Load{-0.59F, 4.0F / 0.41F}, Load{0.99F, 4.0F / 1.99F},
                             Load{-0.61F, 4.0F}, Load{1.01F, 4.0F}, Load{nan, 4.0F}}) {
        vote = {};
        vote.start(suv);
        vote.assume_load(load.excess);
        alone_after(500, 4.0F, 4.0F, 4.0F);
        EXPECT_NEAR(vote.forces().by_roll_mps2, load.force_mps2, 1e-3F) << load.excess;
    }
    vote.assume_load(1.0F);
    vote.assume_load(nan);
    alone_after(500, 4.0F, 4.0F, 4.0F);
    EXPECT_NEAR(vote.forces().by_roll_mps2, 2.0F, 1e-3F);
}

// A ramp of 20 m/s^3: 80 ms ahead it is 1.6 m/s^2 higher, and the lag's own delay does not matter.
TEST_F(AForceVote, KnowsWhatTheAccelerometerShows80MillisecondsLater) {
    for (int sample = 0; sample < 200; ++sample) {
        const float force = 0.2F * static_cast<float>(sample);
        feed(vote, sample_of(force, force, roll_angle_rad(0.0F)));
    }
    EXPECT_NEAR(vote.forces().shown_soon_mps2 - vote.forces().shown_mps2, 1.6F, 0.02F);
}

// At the IMU a steady turn adds nothing.
TEST_F(AForceVote, KnowsItOfAnImuAheadOfTheCentreOfGravityToo) {
    rsi::Parameters suv = parameters();
    suv.imu_x_m = 2.0F;
    vote.start(suv);
    alone_after(500, 4.0F, 4.0F, 4.0F);
    EXPECT_NEAR(vote.forces().shown_soon_mps2, vote.forces().shown_mps2, 1e-3F);
}

TEST_F(AForceVote, NeedsOthersThatAgreeWithinHalfOfWhatTheyHaveAgainstIt) {
    EXPECT_TRUE(alone_after(300, 9.0F, 0.0F, 2.9F));  // 2.9 against half of 6.1
    EXPECT_FALSE(alone_after(300, 9.0F, 0.0F, 3.1F));
    EXPECT_TRUE(alone_after(300, 9.0F, 2.9F, 0.0F));
    EXPECT_FALSE(alone_after(300, 9.0F, 3.1F, 0.0F));
}

TEST_F(AForceVote, IsNotAgainstTheAccelerometerWhenAnotherIsAlone) {
    EXPECT_FALSE(alone_after(300, 4.0F, -4.0F, 4.0F));  // bank or slide
    EXPECT_FALSE(alone_after(300, 4.0F, 4.0F, -4.0F));  // roll sensor
    EXPECT_FALSE(alone_after(300, 0.0F, 4.0F, -4.0F));  // all differ
}

// The roll motion stands by the accelerometer, whatever the yaw rate says; who does not know says no.
TEST_F(AForceVote, HasTheRollMotionAgreeWithin1500MillimetresPerSecondSquared) {
    EXPECT_FALSE(vote.roll_motion_agrees());
    for (const float sign : {1.0F, -1.0F}) {
        alone_after(300, sign * 5.45F, sign * 1.0F, sign * 4.0F);
        EXPECT_TRUE(vote.roll_motion_agrees());
        alone_after(300, sign * 5.55F, sign * 1.0F, sign * 4.0F);
        EXPECT_FALSE(vote.roll_motion_agrees());
        alone_after(300, sign * 4.0F, sign * 1.0F, sign * 4.0F);
        EXPECT_TRUE(vote.roll_motion_agrees());
        feed(vote, sample_of(nan, 1.0F, roll_angle_rad(4.0F)));
        EXPECT_FALSE(vote.roll_motion_agrees());
    }
}

// A roll sensor of wrong scale teaches the load that explains it.
TEST_F(AForceVote, ALoadExcusesTheRollMotionByNoLessThanNothingAndAtMost30Percent) {
    rsi::Parameters suv = parameters();
    suv.load_adaptation = 1.0F;
    vote.start(suv);
    const auto agrees_under = [this](float excess, float force_mps2) {
        vote.assume_load(excess);
        alone_after(500, force_mps2, force_mps2, (1.0F + excess) * force_mps2);
        return vote.roll_motion_agrees();
    };
    EXPECT_TRUE(agrees_under(0.3F, 5.0F));
    EXPECT_TRUE(agrees_under(0.6F, 5.0F));   // 1.2 m/s^2 apart
    EXPECT_FALSE(agrees_under(0.6F, 7.0F));  // 1.6 m/s^2
    EXPECT_TRUE(agrees_under(-0.4F, 3.5F));
    EXPECT_FALSE(agrees_under(-0.4F, 4.0F));
}

// Half of what makes it the only one, and the others need not agree.
TEST_F(AForceVote, SuspectsAnAccelerometerBeyondBothOthersBy1500MillimetresPerSecondSquared) {
    EXPECT_FALSE(vote.accelerometer_is_suspect());
    for (const float sign : {1.0F, -1.0F}) {
        alone_after(300, sign * 5.45F, sign * 4.0F, sign * -4.0F);
        EXPECT_FALSE(vote.accelerometer_is_suspect());
        alone_after(300, sign * 5.55F, sign * 4.0F, sign * -4.0F);
        EXPECT_TRUE(vote.accelerometer_is_suspect());
        alone_after(300, sign * 5.55F, sign * 10.0F, sign * 4.0F);  // between them
        EXPECT_FALSE(vote.accelerometer_is_suspect());
    }
    feed(vote, sample_of(nan, 0.0F, 0.0F));
    EXPECT_FALSE(vote.accelerometer_is_suspect());
}

TEST_F(AForceVote, TellsTheForcesThatItCompares) {
    EXPECT_FALSE(vote.known());
    alone_after(500, 5.0F, 3.0F, 4.0F);
    EXPECT_TRUE(vote.known());
    EXPECT_NEAR(vote.forces().shown_mps2, 5.0F, 1.0e-3F);
    EXPECT_NEAR(vote.forces().by_yaw_mps2, 3.0F, 1.0e-3F);
    EXPECT_NEAR(vote.forces().by_roll_mps2, 4.0F, 1.0e-3F);
    feed(vote, sample_of(nan, 0.0F, 0.0F));
    EXPECT_FALSE(vote.known());
}

// The speed has no sign: of a vehicle that turns to the left while it rolls backwards the force is to the
// right. Above 5 m/s it goes forwards.
TEST_F(AForceVote, TakesTheYawRateOfASlowVehicleForATurnToEitherSide) {
    struct Turn {
        float shown_mps2;
        bool alone;
    };
    for (const float speed_mps : {5.0F, 5.1F}) {
        for (const Turn turn : {Turn{3.9F, false}, Turn{-3.9F, speed_mps > 5.0F}, Turn{-4.1F, true}}) {
            rsi::Inputs inputs = sample_of(turn.shown_mps2, 0.0F, 0.0F);
            inputs.speed_mps = speed_mps;
            inputs.yaw_rate_radps = 1.0F / speed_mps;
            for (int sample = 0; sample < 500; ++sample) {
                feed(vote, inputs);
            }
            EXPECT_EQ(vote.accelerometer_is_alone(), turn.alone) << turn.shown_mps2 << " at " << speed_mps;
        }
    }
}

// The direction of rolling is not known: the accelerometer's value is right up to the turn to either side.
TEST_F(AForceVote, TakesATurnToTheRightForOneToEitherSideAsWell) {
    rsi::Inputs inputs = sample_of(3.9F, 0.0F, 0.0F);
    inputs.speed_mps = 5.0F;
    inputs.yaw_rate_radps = -0.2F;
    for (int sample = 0; sample < 500; ++sample) {
        feed(vote, inputs);
    }
    EXPECT_NEAR(vote.forces().by_yaw_mps2, 1.0F, 1e-3F);
}

TEST_F(AForceVote, NeedsASpeedAndAYawRateHoweverSlowTheVehicleIs) {
    for (const bool with_speed : {true, false}) {
        rsi::Inputs inputs = sample_of(10.0F, 0.0F, 0.0F);
        inputs.speed_mps = with_speed ? 1.0F : nan;
        inputs.yaw_rate_radps = with_speed ? nan : 0.0F;
        feed(vote, inputs);
        EXPECT_FALSE(vote.known());
    }
}

TEST_F(AForceVote, StartsAnewFarOverAndWithoutAReference) {
    struct Gap {
        float lateral;
        float by_yaw;
        float roll_angle;
        float roll_rate;
    };
    for (const Gap gap :
         {Gap{20.0F, 0.0F, 0.151F, 0.0F}, Gap{-20.0F, 0.0F, -0.151F, 0.0F}, Gap{nan, 0.0F, 0.0F, 0.0F},
          Gap{10.0F, nan, 0.0F, 0.0F}, Gap{10.0F, 0.0F, nan, 0.0F}, Gap{10.0F, 0.0F, 0.0F, nan},
          Gap{infinity, 0.0F, 0.0F, 0.0F}}) {
        ASSERT_TRUE(alone_after(100, 10.0F, 0.0F, 0.0F));
        feed(vote, sample_of(gap.lateral, gap.by_yaw, gap.roll_angle, gap.roll_rate));
        EXPECT_FALSE(vote.accelerometer_is_alone());
        EXPECT_FALSE(alone_after(10, 10.0F, 0.0F, 0.0F));
    }
}

// For each pair of references: 10 m/s^2 are 3 after 0.11 s.
TEST_F(AForceVote, TakesThatMeanFromItsStartAndAfterAGapWhicheverOtherIsNearer) {
    struct Others {
        float by_yaw;
        float by_roll;
    };
    for (const float sign : {1.0F, -1.0F}) {
        for (const Others others : {Others{0.0F, -4.0F}, Others{-4.0F, 0.0F}}) {
            vote = ForceVote{};
            vote.start(parameters());
            for (int times = 0; times < 2; ++times) {
                EXPECT_FALSE(alone_after(10, sign * 10.0F, sign * others.by_yaw, sign * others.by_roll));
                EXPECT_TRUE(alone_after(1, sign * 10.0F, sign * others.by_yaw, sign * others.by_roll));
                feed(vote, sample_of(nan, 0.0F, 0.0F));
            }
        }
    }
}

TEST_F(AForceVote, JudgesABodyUpTo150Milliradians) {
    for (const float sign : {1.0F, -1.0F}) {
        const float angle_rad = sign * 0.149F;
        const float by_roll_mps2 = angle_rad / roll_angle_rad(1.0F);
        EXPECT_TRUE(alone_after(100, by_roll_mps2 + sign * 4.0F, by_roll_mps2, by_roll_mps2));
    }
}

TEST_F(AForceVote, SaysNothingOfAVehicleWithoutALeverArm) {
    rsi::Parameters flat = parameters();
    flat.fixed_roll_centre_height_m = flat.sprung_cg_height_m;
    vote.start(flat);
    EXPECT_FALSE(alone_after(300, 10.0F, 0.0F, 0.0F));
}

// A heavy truck that is steered to and fro: its body follows by a quarter of a period, its yaw rate runs
// ahead, and its IMU sits far from the centre of gravity. Neither the angle alone nor the IMU's reading is
// the force.
class AForceVoteOfASwingingTruck : public ::testing::Test {
 protected:
    void SetUp() override {
        truck_.sprung_mass_kg = 7600.0F;
        truck_.sprung_cg_height_m = 1.25F;
        truck_.fixed_roll_centre_height_m = 0.25F;
        truck_.roll_stiffness_nmprad = 500.0e3F;
        truck_.roll_damping_nmsprad = 60.0e3F;
        truck_.roll_inertia_kgm2 = 9.0e3F;
        truck_.imu_x_m = 1.8F;
        truck_.imu_z_m = -0.6F;
    }

    // The vote's demanded result for the last two of five seconds, in every sample; `gain`: of the
    // accelerometer.
    struct Said {
        int alone{0};
        int agrees{0};
    };
    Said drive(float gain) const {
        ForceVote vote;
        vote.start(truck_);
        Said said;
        double angle_rad = 0.0;
        double rate_radps = 0.0;
        constexpr int substeps = 100;
        constexpr double step_s = 0.01 / substeps;
        const double arm_kgm = static_cast<double>(truck_.sprung_mass_kg);  // 1 m
        for (int sample = 0; sample < 500; ++sample) {
            double force_mps2 = 0.0;
            double acceleration_radps2 = 0.0;
            double yaw_radps = 0.0;
            double yaw_radps2 = 0.0;
            for (int substep = 1; substep <= substeps; ++substep) {
                const double time_s = (sample * substeps + substep) * step_s;
                force_mps2 = 4.5 * std::sin(7.0 * time_s);
                yaw_radps = 0.3 * std::sin(7.0 * time_s + 1.5);
                yaw_radps2 = 2.1 * std::cos(7.0 * time_s + 1.5);
                acceleration_radps2 =
                    (arm_kgm * force_mps2 - static_cast<double>(truck_.roll_stiffness_nmprad) * angle_rad -
                     static_cast<double>(truck_.roll_damping_nmsprad) * rate_radps) /
                    static_cast<double>(truck_.roll_inertia_kgm2);
                rate_radps += step_s * acceleration_radps2;
                angle_rad += step_s * rate_radps;
            }
            const double at_imu_mps2 = force_mps2 + static_cast<double>(truck_.imu_x_m) * yaw_radps2 -
                                       static_cast<double>(truck_.imu_z_m) * acceleration_radps2;
            feed(vote, sample_of(gain * static_cast<float>(at_imu_mps2), static_cast<float>(20.0 * yaw_radps),
                                 static_cast<float>(angle_rad), static_cast<float>(rate_radps)));
            if (sample >= 300) {
                said.alone += vote.accelerometer_is_alone() ? 1 : 0;
                said.agrees += vote.roll_motion_agrees() ? 1 : 0;
            }
        }
        return said;
    }

    rsi::Parameters truck_{rsi_test_large_suv()};
};

TEST_F(AForceVoteOfASwingingTruck, IsNotAgainstAGoodAccelerometer) {
    const Said said = drive(1.0F);
    EXPECT_EQ(said.alone, 0);
    EXPECT_EQ(said.agrees, 200);
}

TEST_F(AForceVoteOfASwingingTruck, HasTheRollMotionDisagreeWithOneOfTheOtherSign) {
    EXPECT_LT(drive(-1.0F).agrees, 150);
}

// From the first sample on, and after a gap: what the lags begin with is where the vehicle is.
TEST_F(AForceVoteOfASwingingTruck, HasNoAccelerationInItsFirstSample) {
    ForceVote vote;
    vote.start(truck_);
    const float angle_rad = 0.1F;
    for (int times = 0; times < 2; ++times) {
        feed(vote, sample_of(8.0F, 8.0F, angle_rad));  // yaws at 0.4 rad/s
        EXPECT_TRUE(vote.roll_motion_agrees());
        feed(vote, sample_of(nan, 0.0F, 0.0F));
        feed(vote, sample_of(8.0F, 0.0F, angle_rad, 0.6F));
        EXPECT_TRUE(vote.roll_motion_agrees());
        feed(vote, sample_of(nan, 0.0F, 0.0F));
    }
}

TEST_F(AForceVoteOfASwingingTruck, HasNoAccelerationWhileTheRollRateStays) {
    ForceVote vote;
    vote.start(truck_);
    ForceVote without_damping = vote;
    const float rate_radps = 0.25F;
    const float damping_mps2 = truck_.roll_damping_nmsprad / truck_.sprung_mass_kg * rate_radps;
    float angle_rad = -0.14F;
    for (int sample = 0; sample < 110; ++sample) {
        angle_rad += 0.01F * rate_radps;
        const float held_mps2 = truck_.roll_stiffness_nmprad / truck_.sprung_mass_kg * angle_rad;
        feed(vote, sample_of(held_mps2 + damping_mps2, held_mps2 + damping_mps2, angle_rad, rate_radps));
        feed(without_damping, sample_of(held_mps2, held_mps2, angle_rad, rate_radps));
    }
    EXPECT_TRUE(vote.roll_motion_agrees());
    EXPECT_FALSE(without_damping.roll_motion_agrees());
}

// A road that turns below a body that does not roll against it.
TEST_F(AForceVoteOfASwingingTruck, IsDampedAgainstTheRoad) {
    ForceVote vote;
    vote.start(truck_);
    for (int sample = 0; sample < 100; ++sample) {
        feed(vote, sample_of(0.0F, 0.0F, 0.0F, 0.33F));
    }
    EXPECT_TRUE(vote.roll_motion_agrees());
}

// An accelerometer that is off by 4 m/s^2, far in front of a vehicle that begins to yaw at 1 rad/s^2.
TEST_F(AForceVoteOfASwingingTruck, TakesTheYawAccelerationAtTheIMUFromBothReferences) {
    ForceVote vote;
    vote.start(truck_);
    for (int sample = 1; sample <= 100; ++sample) {
        rsi::Inputs inputs = sample_of(4.0F + truck_.imu_x_m, 0.0F, 0.0F);
        inputs.yaw_rate_radps = 0.01F * static_cast<float>(sample);
        inputs.speed_mps = 1.0F;
        feed(vote, inputs);
    }
    EXPECT_TRUE(vote.accelerometer_is_alone());
}

TEST(AForceVoteThatHasNotStarted, SaysNothing) {
    ForceVote vote;
    for (int sample = 0; sample < 300; ++sample) {
        feed(vote, sample_of(10.0F, 0.0F, 0.0F));
    }
    EXPECT_FALSE(vote.accelerometer_is_alone());
}

}  // namespace
}  // namespace monitoring_consistency_test
