// All wheels in the air, and what only looks like it.
#include <gtest/gtest.h>

#include <limits>

#include "rsi/ecu/monitoring/flight.hpp"

namespace monitoring_flight_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class AFlight : public ::testing::Test {
 protected:
    bool excuses(int samples, float vertical_mps2, float lateral_mps2 = 0.0F) {
        for (int sample = 0; sample < samples; ++sample) {
            flight.update(vertical_mps2, lateral_mps2);
        }
        return flight.excuses();
    }

    rsi::monitoring::Flight flight;
};

TEST_F(AFlight, BeginsAfter50MillisecondsWithoutAForce) {
    for (const float sign : {1.0F, -1.0F}) {
        flight = {};
        EXPECT_FALSE(excuses(4, sign * 1.49F, sign * 1.49F));
        EXPECT_TRUE(excuses(1, sign * 1.49F, sign * 1.49F));
    }
}

TEST_F(AFlight, IsNoneOfABodyThatIsHeld) {
    for (const float sign : {1.0F, -1.0F}) {
        EXPECT_FALSE(excuses(10, sign * 1.51F));
        EXPECT_FALSE(excuses(10, 0.0F, sign * 1.51F));
        EXPECT_FALSE(excuses(10, nan));
        EXPECT_FALSE(excuses(10, 0.0F, nan));
        EXPECT_FALSE(excuses(4, 0.0F));
        EXPECT_FALSE(excuses(1, 10.0F));
    }
}

TEST_F(AFlight, ExcusesASecondAfterTheLanding) {
    ASSERT_TRUE(excuses(50, 0.0F));
    EXPECT_TRUE(excuses(99, 60.0F, 10.0F));
    EXPECT_FALSE(excuses(1, 10.0F));
    EXPECT_FALSE(excuses(4, 0.0F));  // and another one begins anew
    EXPECT_TRUE(excuses(1, 0.0F));
}

TEST_F(AFlight, IsNotInterruptedByAHop) {
    ASSERT_TRUE(excuses(50, 0.0F));
    EXPECT_TRUE(excuses(50, 20.0F));
    EXPECT_TRUE(excuses(4, 0.0F));
}

// An accelerometer that has failed at zero.
TEST_F(AFlight, IsNoneWhenItLastsForMoreThanASecond) {
    EXPECT_TRUE(excuses(100, 0.0F));
    EXPECT_FALSE(excuses(1, 0.0F));
    EXPECT_FALSE(excuses(500, 0.0F));
}

// An accelerometer that has lost gravity, on a rough road.
TEST_F(AFlight, EndsInForcesThatNeverCarryTheVehicle) {
    for (int times = 0; times < 100; ++times) {
        excuses(6, 0.5F);
        excuses(1, 2.0F);
    }
    EXPECT_FALSE(excuses(6, 0.5F));
    EXPECT_FALSE(excuses(29, 10.0F));
    EXPECT_FALSE(excuses(6, 0.5F));
    EXPECT_FALSE(excuses(30, 10.0F));
    EXPECT_TRUE(excuses(6, 0.5F));
}

TEST_F(AFlight, IsNoneWhenTheVehicleTurns) {
    ASSERT_TRUE(excuses(50, 0.0F));
    EXPECT_FALSE(excuses(1, 0.0F, 3.0F));
    EXPECT_TRUE(excuses(50, 0.0F));  // a second in all
    EXPECT_FALSE(excuses(1, 0.0F));
}

}  // namespace
}  // namespace monitoring_flight_test
