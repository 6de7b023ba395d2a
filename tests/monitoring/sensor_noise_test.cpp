// A signal that turns back from sample to sample.
#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

#include "rsi/ecu/monitoring/sensor_noise.hpp"

namespace monitoring_sensor_noise_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

bool is_known_after(std::initializer_list<float> values) {
    rsi::monitoring::SensorNoise noise;
    for (const float value : values) {
        noise.update(value);
    }
    return noise.is_known();
}

TEST(ASensorsNoise, IsKnownWhenItHasTurnedBackThreeTimes) {
    EXPECT_FALSE(is_known_after({9.0F, 9.1F, 9.0F, 9.1F}));
    EXPECT_TRUE(is_known_after({9.0F, 9.1F, 9.0F, 9.1F, 9.0F}));
    EXPECT_TRUE(is_known_after({9.0F, 9.1F, 9.0F, 9.1F, 9.0F, 9.0F, 9.0F, 9.0F}));
}

TEST(ASensorsNoise, IsNotSeenInASignalThatMovesSmoothlyOrStands) {
    EXPECT_FALSE(is_known_after({9.0F, 9.0F, 9.0F, 9.0F, 9.0F, 9.0F, 9.0F}));
    EXPECT_FALSE(is_known_after({1.0F, 2.0F, 3.0F, 4.0F, 4.0F, 3.0F, 2.0F, 2.0F, 3.0F, 3.0F, 2.0F}));
}

// From accelerating to braking and back.
TEST(ASensorsNoise, IsNotSeenInTurnsThatAreFarApart) {
    const auto is_known = [](int samples) {
        rsi::monitoring::SensorNoise noise;
        float value = 10.0F;
        for (int turn = 0; turn < 8; ++turn) {
            for (int sample = 0; sample < samples; ++sample) {
                value += (turn % 2 == 0) ? 0.1F : -0.1F;
                noise.update(value);
            }
        }
        return noise.is_known();
    };
    EXPECT_TRUE(is_known(20));
    EXPECT_FALSE(is_known(22));
}

TEST(ASensorsNoise, IsNotSeenInAGap) {
    EXPECT_FALSE(is_known_after({9.0F, 9.1F, nan, 9.0F, nan, 9.1F, nan, 9.0F, nan}));
}

}  // namespace
}  // namespace monitoring_sensor_noise_test
