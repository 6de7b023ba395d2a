// How far the roll angle is behind the roll rate in time: what counts as in time, how much the body must have
// rolled before anything is said, and what does not matter.
#include "rsi/ecu/monitoring/roll_lag.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace monitoring_roll_lag_test {
namespace {

using rsi::monitoring::RollLag;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float sample_ms = 10.0F;

// A body that rolls to and fro, and a roll sensor that is late.
class ALateRollAngle : public ::testing::Test {
 protected:
    // With a root mean square of 0.1 rad/s, at so many Hz.
    void roll(int samples, float lag_ms, float frequency_hz = 0.5F, float rate_radps = 0.1F) {
        for (int sample = 0; sample < samples; ++sample) {
            time_s += 0.01F;
            rate = rate_radps * std::sqrt(2.0F) * std::sin(6.2831853F * frequency_hz * time_s);
            for (std::size_t back = angles.size() - 1U; back > 0U; --back) {
                angles[back] = angles[back - 1U];
            }
            angles[0] += 0.01F * rate;
            lag.update(late(lag_ms) + offset_rad, rate);
            offset_rad += drift_radps * 0.01F;
        }
    }

    // Between the two samples that are nearest to that time.
    float late(float lag_ms) const {
        const auto newer = static_cast<std::size_t>(lag_ms / sample_ms);
        const float share = lag_ms / sample_ms - static_cast<float>(newer);
        return angles[newer] + share * (angles[newer + 1U] - angles[newer]);
    }

    RollLag lag;
    std::array<float, 32> angles{};
    float time_s{0.0F};
    float rate{0.0F};
    float offset_rad{0.0F};
    float drift_radps{0.0F};
};

TEST_F(ALateRollAngle, IsInTimeUpTo35Milliseconds) {
    for (const float lag_ms : {0.0F, 20.0F, 34.0F}) {
        lag = {};
        roll(1000, lag_ms);
        EXPECT_TRUE(lag.angle_is_in_time()) << lag_ms;
    }
    for (const float lag_ms : {36.0F, 50.0F, 100.0F, 200.0F}) {
        lag = {};
        roll(1000, lag_ms);
        EXPECT_FALSE(lag.angle_is_in_time()) << lag_ms;
    }
}

TEST_F(ALateRollAngle, OrALateRateIsInTimeUpTo35MillisecondsAndOnlyOnceTheBodyHasRolledEnough) {
    for (const float lag_ms : {0.0F, 34.0F, 36.0F, 50.0F, 100.0F}) {
        RollLag of_rate;
        roll(40, 100.0F);
        for (int sample = 0; sample < 1000; ++sample) {
            roll(1, 0.0F);
            const float late_rate = (late(lag_ms) - late(lag_ms + sample_ms)) / 0.01F;
            of_rate.update(late(0.0F), late_rate);
        }
        EXPECT_EQ(of_rate.rate_is_in_time(), lag_ms < 35.0F) << lag_ms;
    }
    lag = {};
    EXPECT_FALSE(lag.rate_is_in_time());
    roll(100, 0.0F, 4.0F);
    EXPECT_FALSE(lag.rate_is_in_time());
    roll(10, 0.0F, 4.0F);
    EXPECT_TRUE(lag.rate_is_in_time());
}

// A second at 0.1 rad/s; fast enough to be no bank.
TEST_F(ALateRollAngle, IsInTimeOnlyOnceTheBodyHasRolledEnough) {
    EXPECT_FALSE(lag.angle_is_in_time());
    roll(100, 0.0F, 4.0F);
    EXPECT_FALSE(lag.angle_is_in_time());
    roll(10, 0.0F, 4.0F);
    EXPECT_TRUE(lag.angle_is_in_time());
}

TEST_F(ALateRollAngle, IsNotJudgedByABodyThatRestsOrByASlowBank) {
    roll(10000, 0.0F, 0.5F, 0.0F);
    EXPECT_FALSE(lag.angle_is_in_time());
    drift_radps = 0.1F;
    roll(100, 0.0F, 0.5F, 0.0F);
    EXPECT_FALSE(lag.angle_is_in_time());
}

TEST_F(ALateRollAngle, IsJudgedWhateverItsOffsetAndTheRoadsBank) {
    for (const float offset : {0.3F, -0.3F}) {
        for (const float lag_ms : {30.0F, 40.0F}) {
            lag = {};
            offset_rad = offset;
            drift_radps = 0.02F * offset;
            roll(1000, lag_ms);
            EXPECT_EQ(lag.angle_is_in_time(), lag_ms < 35.0F);
        }
    }
}

// A jump while the body rolls looks as a lag of many times itself.
TEST_F(ALateRollAngle, ForgetsAJumpOfTheAngle) {
    for (const float jump_rad : {1.4F, -1.4F}) {
        lag = {};
        roll(300, 0.0F);
        ASSERT_TRUE(lag.angle_is_in_time() && lag.rate_is_in_time());
        offset_rad += jump_rad;
        roll(20, 0.0F);
        ASSERT_FALSE(lag.angle_is_in_time() && lag.rate_is_in_time());
        roll(2000, 0.0F);
        EXPECT_TRUE(lag.angle_is_in_time());
        EXPECT_TRUE(lag.rate_is_in_time());
    }
}

// Findings before a gap do not count after it.
TEST_F(ALateRollAngle, StartsAnewAfterASampleThatIsNotFinite) {
    for (const bool of_angle : {true, false}) {
        for (const float bad : {nan, infinity}) {
            lag = {};
            roll(1000, 0.0F);
            ASSERT_TRUE(lag.angle_is_in_time());
            lag.update(of_angle ? bad : angles[0], of_angle ? 0.1F : bad);
            EXPECT_FALSE(lag.angle_is_in_time());
            roll(1000, 50.0F);
            EXPECT_FALSE(lag.angle_is_in_time());
            lag.update(of_angle ? bad : angles[0], of_angle ? 0.1F : bad);
            roll(1000, 20.0F);
            EXPECT_TRUE(lag.angle_is_in_time());
        }
    }
}

}  // namespace
}  // namespace monitoring_roll_lag_test
