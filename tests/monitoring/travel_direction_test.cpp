// Forwards or backwards, when the speed has no sign.
#include <gtest/gtest.h>

#include <limits>

#include "rsi/ecu/monitoring/travel_direction.hpp"

namespace monitoring_travel_direction_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class ATravelDirection : public ::testing::Test {
 protected:
    bool forward(float speed_mps, float lateral_mps2 = 0.0F, float turn_mps2 = 0.0F) {
        direction.update(lateral_mps2, turn_mps2 / speed_mps, speed_mps);
        return direction.is_forward();
    }

    rsi::monitoring::TravelDirection direction;
};

TEST_F(ATravelDirection, IsForwardAfterAReset) {
    EXPECT_TRUE(direction.is_forward());
}

TEST_F(ATravelDirection, IsUnknownAfterAStandstill) {
    EXPECT_TRUE(forward(1.01F, 5.0F, -5.0F));
    EXPECT_FALSE(forward(0.99F));
    EXPECT_FALSE(forward(10.0F));
}

TEST_F(ATravelDirection, IsForwardBeyond14MetresASecond) {
    ASSERT_FALSE(forward(0.5F));
    EXPECT_FALSE(forward(13.99F));
    EXPECT_TRUE(forward(14.01F));
    EXPECT_TRUE(forward(2.0F));
}

TEST_F(ATravelDirection, IsForwardWhenAClearTurnSaysSo) {
    for (const float sign : {1.0F, -1.0F}) {
        ASSERT_FALSE(forward(0.5F));
        EXPECT_FALSE(forward(8.0F, sign * 1.99F, sign * 5.0F));
        EXPECT_FALSE(forward(8.0F, sign * 5.0F, sign * 1.99F));
        EXPECT_FALSE(forward(8.0F, sign * 5.0F, sign * -5.0F));
        EXPECT_TRUE(forward(8.0F, sign * 2.01F, sign * 2.01F));
    }
}

TEST_F(ATravelDirection, StaysWhenNothingIsKnown) {
    EXPECT_TRUE(forward(nan));
    ASSERT_FALSE(forward(0.5F));
    EXPECT_FALSE(forward(nan, 5.0F, 5.0F));
    EXPECT_FALSE(forward(8.0F, nan, 5.0F));
    EXPECT_FALSE(forward(8.0F, 5.0F, nan));
}

}  // namespace
}  // namespace monitoring_travel_direction_test
