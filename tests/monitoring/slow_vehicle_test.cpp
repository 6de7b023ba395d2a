// The lateral acceleration of a vehicle that hardly moves.
#include <gtest/gtest.h>

#include <limits>

#include "rsi/ecu/monitoring/slow_vehicle.hpp"

namespace monitoring_slow_vehicle_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class ASlowVehicle : public ::testing::Test {
 protected:
    bool impossible(int samples, float lateral_mps2, float speed_mps = 0.0F, float yaw_rate_radps = 0.0F) {
        rsi::Inputs inputs{};
        inputs.lateral_specific_force_mps2 = lateral_mps2;
        inputs.speed_mps = speed_mps;
        inputs.yaw_rate_radps = yaw_rate_radps;
        for (int sample = 0; sample < samples; ++sample) {
            vehicle.update(inputs);
        }
        return vehicle.lateral_acceleration_is_impossible();
    }

    rsi::monitoring::SlowVehicle vehicle;
};

TEST_F(ASlowVehicle, HasNoMoreThan8500MillimetresPerSecondSquared) {
    EXPECT_FALSE(vehicle.lateral_acceleration_is_impossible());
    for (const float sign : {1.0F, -1.0F}) {
        EXPECT_FALSE(impossible(1, sign * 8.49F));
        EXPECT_TRUE(impossible(1, sign * 8.51F));
        EXPECT_FALSE(impossible(1, sign * 8.49F));
    }
}

// Backwards as well: the speed has no sign.
TEST_F(ASlowVehicle, HasWhatItTurnsWithBesides) {
    for (const float yaw_rate : {0.5F, -0.5F}) {
        EXPECT_FALSE(impossible(1, 10.49F, 4.0F, yaw_rate));
        EXPECT_TRUE(impossible(1, 10.51F, 4.0F, yaw_rate));
    }
}

TEST_F(ASlowVehicle, IsNoLongerSlowAbove5MetresPerSecond) {
    EXPECT_TRUE(impossible(1, 20.0F, 5.0F));
    EXPECT_FALSE(impossible(1, 20.0F, 5.01F));
}

TEST_F(ASlowVehicle, IsOneAfter3Seconds) {
    for (const float sign : {1.0F, -1.0F}) {
        impossible(1, 0.0F, 20.0F);
        EXPECT_FALSE(impossible(299, sign * 3.99F));
        EXPECT_FALSE(impossible(1, sign * 9.0F));
        EXPECT_FALSE(impossible(1, sign * 3.99F));
        EXPECT_TRUE(impossible(1, sign * 9.0F));
    }
}

// Its wheels roll slowly while it slides sideways, and it may tip over as it stops.
TEST_F(ASlowVehicle, IsNoneWhileItSlides) {
    impossible(1, 0.0F, 20.0F);
    EXPECT_FALSE(impossible(1000, 4.01F));
    EXPECT_FALSE(impossible(100, 9.0F));
    EXPECT_FALSE(impossible(1000, nan));
    EXPECT_FALSE(impossible(1, 9.0F));
}

TEST_F(ASlowVehicle, SlidesByWhatIsMoreThanTheTurn) {
    impossible(1, 0.0F, 20.0F);
    impossible(300, 5.99F, 4.0F, -0.5F);
    EXPECT_TRUE(impossible(1, 9.0F));
}

TEST_F(ASlowVehicle, SaysNothingOfWhatIsNotKnown) {
    EXPECT_FALSE(impossible(1, nan));
    EXPECT_FALSE(impossible(1, 20.0F, 0.0F, nan));
    EXPECT_FALSE(impossible(1, 20.0F, nan));
    EXPECT_FALSE(impossible(1, 20.0F));
}

}  // namespace
}  // namespace monitoring_slow_vehicle_test
