// Lateral acceleration, yaw rate and roll angle of a turn: which of them has another sign than the two
// others, how far beyond zero each must be, and for how long.
#include "rsi/ecu/monitoring/turn_signs.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace monitoring_turn_signs_test {
namespace {

using rsi::monitoring::TurnSigns;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

constexpr int lateral_samples = 20;  // 0.2 s
constexpr int yaw_samples = 120;     // 1.2 s

struct Turn {
    float lateral_mps2;
    float by_yaw_mps2;
    float roll_angle_rad;
};

// To the left; the same mirrored is one to the right.
constexpr Turn lateral_lies{-5.0F, 5.0F, 0.05F};
constexpr Turn yaw_lies{5.0F, -5.0F, 0.05F};

class TheSignsOfATurn : public ::testing::Test {
 protected:
    void run(int samples, const Turn& turn, float side = 1.0F) {
        for (int sample = 0; sample < samples; ++sample) {
            signs.update(side * turn.lateral_mps2, side * turn.by_yaw_mps2, side * turn.roll_angle_rad);
        }
    }

    // After as long as either takes.
    void expect_none_alone(const Turn& turn) {
        for (const float side : {1.0F, -1.0F}) {
            signs = {};
            run(200, turn, side);
            EXPECT_FALSE(signs.lateral_acceleration_is_alone());
            EXPECT_FALSE(signs.yaw_rate_is_alone());
        }
    }

    TurnSigns signs;
};

TEST_F(TheSignsOfATurn, LeaveTheLateralAccelerationAloneAfter200Milliseconds) {
    for (const float side : {1.0F, -1.0F}) {
        signs = {};
        EXPECT_FALSE(signs.lateral_acceleration_is_alone());
        run(lateral_samples - 1, lateral_lies, side);
        EXPECT_FALSE(signs.lateral_acceleration_is_alone());
        run(1, lateral_lies, side);
        EXPECT_TRUE(signs.lateral_acceleration_is_alone());
        run(1000, lateral_lies, side);
        EXPECT_TRUE(signs.lateral_acceleration_is_alone());
        EXPECT_FALSE(signs.yaw_rate_is_alone());
    }
}

TEST_F(TheSignsOfATurn, LeaveTheYawRateAloneAfter1200Milliseconds) {
    for (const float side : {1.0F, -1.0F}) {
        signs = {};
        run(yaw_samples - 1, yaw_lies, side);
        EXPECT_FALSE(signs.yaw_rate_is_alone());
        run(1, yaw_lies, side);
        EXPECT_TRUE(signs.yaw_rate_is_alone());
        run(1000, yaw_lies, side);
        EXPECT_TRUE(signs.yaw_rate_is_alone());
        EXPECT_FALSE(signs.lateral_acceleration_is_alone());
    }
}

TEST_F(TheSignsOfATurn, CountAnewAfterOneSampleWithoutAContradiction) {
    const Turn good{5.0F, 5.0F, 0.05F};
    run(lateral_samples - 1, lateral_lies);
    run(1, good);
    run(lateral_samples - 1, lateral_lies);
    EXPECT_FALSE(signs.lateral_acceleration_is_alone());
    run(1, lateral_lies);
    EXPECT_TRUE(signs.lateral_acceleration_is_alone());
    run(1, good);
    EXPECT_FALSE(signs.lateral_acceleration_is_alone());

    run(yaw_samples - 1, yaw_lies);
    run(1, good);
    run(yaw_samples - 1, yaw_lies);
    EXPECT_FALSE(signs.yaw_rate_is_alone());
    run(1, yaw_lies);
    EXPECT_TRUE(signs.yaw_rate_is_alone());
    run(1, good);
    EXPECT_FALSE(signs.yaw_rate_is_alone());
}

TEST_F(TheSignsOfATurn, OfAllThreeTheSameContradictNone) {
    expect_none_alone({5.0F, 5.0F, 0.05F});
}

// A body that leans into a turn whose accelerations agree is the roll sensor's matter.
TEST_F(TheSignsOfATurn, DoNotJudgeTheRollAngle) {
    expect_none_alone({5.0F, 5.0F, -0.05F});
}

TEST_F(TheSignsOfATurn, SayNothingBelow2MetresPerSecondSquared) {
    expect_none_alone({-2.0F, 5.0F, 0.05F});
    expect_none_alone({-5.0F, 2.0F, 0.05F});
    expect_none_alone({2.0F, -5.0F, 0.05F});
    expect_none_alone({5.0F, -2.0F, 0.05F});
    run(lateral_samples, {-2.001F, 5.0F, 0.05F});
    EXPECT_TRUE(signs.lateral_acceleration_is_alone());
    signs = {};
    run(lateral_samples, {-5.0F, 2.001F, 0.05F});
    EXPECT_TRUE(signs.lateral_acceleration_is_alone());
}

TEST_F(TheSignsOfATurn, SayNothingOfABodyThatHardlyRolls) {
    expect_none_alone({-5.0F, 5.0F, 0.015F});
    expect_none_alone({5.0F, -5.0F, 0.015F});
    run(lateral_samples, {-5.0F, 5.0F, 0.0151F});
    EXPECT_TRUE(signs.lateral_acceleration_is_alone());
    run(yaw_samples, {5.0F, -5.0F, 0.0151F});
    EXPECT_TRUE(signs.yaw_rate_is_alone());
}

TEST_F(TheSignsOfATurn, SayNothingOfWhatIsNotFinite) {
    expect_none_alone({nan, 5.0F, 0.05F});
    expect_none_alone({5.0F, nan, 0.05F});
    expect_none_alone({-5.0F, 5.0F, nan});
}

}  // namespace
}  // namespace monitoring_turn_signs_test
