// The roll angle after a start: when it is used at once, and until when it waits.
#include "rsi/ecu/monitoring/starting_angle.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace monitoring_starting_angle_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

using rsi::monitoring::StartingAngle;

TEST(AStartingAngle, OfEverydayDrivingIsUsedAtOnce) {
    for (const float angle_rad : {0.1F, -0.1F}) {
        StartingAngle start;
        EXPECT_FALSE(start.waits(angle_rad, nan));
        EXPECT_FALSE(start.waits(1.0F, 1.0F));  // from here on other checks judge it
        EXPECT_FALSE(start.is_contradicted());
    }
}

TEST(AStartingAngle, ThatIsLargerWaitsForTheObserver) {
    for (const float sign : {1.0F, -1.0F}) {
        StartingAngle start;
        EXPECT_TRUE(start.waits(0.11F * sign, nan));
        EXPECT_TRUE(start.waits(0.11F * sign, 0.051F * sign));
        EXPECT_FALSE(start.waits(0.11F * sign, 0.05F * sign));
        EXPECT_FALSE(start.is_contradicted());
        EXPECT_FALSE(start.waits(1.0F, 1.0F));
    }
}

TEST(AStartingAngle, IsContradictedOnceTheWaitEndsWithoutConfirmation) {
    StartingAngle start;
    for (int sample = 0; sample < 39; ++sample) {
        EXPECT_TRUE(start.waits(0.2F, 0.15F));
        EXPECT_FALSE(start.is_contradicted());
    }
    EXPECT_FALSE(start.waits(0.2F, 0.15F));
    EXPECT_TRUE(start.is_contradicted());
    EXPECT_FALSE(start.waits(0.2F, 0.15F));
    EXPECT_FALSE(start.is_contradicted());  // said once
}

TEST(AStartingAngle, IsUsedAfterTheWaitIfNoObserverIsThere) {
    StartingAngle start;
    for (int sample = 0; sample < 39; ++sample) {
        EXPECT_TRUE(start.waits(0.2F, nan));
    }
    EXPECT_FALSE(start.waits(0.2F, nan));
    EXPECT_FALSE(start.is_contradicted());
}

TEST(AStartingAngle, ThatIsNotThereDoesNotShortenTheWait) {
    StartingAngle start;
    for (int sample = 0; sample < 100; ++sample) {
        EXPECT_FALSE(start.waits(nan, 0.15F));
    }
    EXPECT_TRUE(start.waits(0.2F, 0.15F));
}

}  // namespace
}  // namespace monitoring_starting_angle_test
