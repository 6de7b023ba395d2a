// Two-wheel lift-off: how long it must last, when it began, and towards which side the vehicle falls.
#include "sil/judge/two_wheel_lift.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace two_wheel_lift_test {
namespace {

using sil::WarningSide;

class TwoWheelLift : public ::testing::Test {
 protected:
    // Advances by this number of steps of 1 ms.
    void steps(int count, bool left_up, bool right_up, double acceleration_mps2 = 0.0) {
        for (int step = 0; step < count; ++step) {
            ++time_ms_;
            observer_.observe({0.001 * time_ms_, acceleration_mps2, 0.001 * time_ms_}, left_up, right_up);
        }
    }
    const std::optional<sil::TwoWheelLiftOff>& lift_off() const { return observer_.lift_off(); }
    std::optional<double> brief_s() const { return observer_.brief_time_s(); }

 private:
    sil::TwoWheelLiftObserver observer_;
    int time_ms_{0};
};

TEST_F(TwoWheelLift, HasToLastFiftyMilliseconds) {
    steps(100, false, false);
    steps(50, true, false);  // from 0.101 to 0.150 s
    EXPECT_FALSE(lift_off());
    EXPECT_DOUBLE_EQ(brief_s().value(), 0.101);
    steps(1, true, false);
    ASSERT_TRUE(lift_off());
    EXPECT_FALSE(brief_s());
}

TEST_F(TwoWheelLift, IsTheMomentAtWhichItBegan) {
    steps(100, false, false);
    steps(200, false, true);
    ASSERT_TRUE(lift_off());
    EXPECT_DOUBLE_EQ(lift_off()->moment.time_s, 0.101);
    EXPECT_DOUBLE_EQ(lift_off()->moment.roll_angle_rad, 0.101);
}

TEST_F(TwoWheelLift, TheVehicleFallsToTheSideThatStaysDown) {
    steps(51, true, false, -1.0);
    EXPECT_EQ(lift_off()->side, WarningSide::right);
}

TEST_F(TwoWheelLift, OfTheRightWheelsTheVehicleFallsToTheLeft) {
    steps(51, false, true, 1.0);
    EXPECT_EQ(lift_off()->side, WarningSide::left);
}

TEST_F(TwoWheelLift, OfAVehicleInTheAirTheFirstSideCounts) {
    steps(1, false, true);
    steps(50, true, true);
    EXPECT_EQ(lift_off()->side, WarningSide::left);
    EXPECT_DOUBLE_EQ(lift_off()->moment.time_s, 0.001);
}

TEST_F(TwoWheelLift, OfAllWheelsAtOnceTheVehicleFallsToTheOutsideOfTheTurn) {
    steps(51, true, true, -3.0);
    EXPECT_EQ(lift_off()->side, WarningSide::left);
}

TEST_F(TwoWheelLift, OneSideAfterTheOtherIsNoLastingLift) {
    steps(40, true, false);
    steps(40, false, true);
    EXPECT_FALSE(lift_off());
    EXPECT_DOUBLE_EQ(brief_s().value(), 0.001);
}

TEST_F(TwoWheelLift, OnlyTheFirstLastingOneCounts) {
    steps(30, true, false);
    steps(10, false, false);
    steps(60, true, false);  // from 0.041 s
    steps(10, false, false);
    steps(60, false, true);
    EXPECT_DOUBLE_EQ(lift_off()->moment.time_s, 0.041);
    EXPECT_EQ(lift_off()->side, WarningSide::right);
    EXPECT_DOUBLE_EQ(brief_s().value(), 0.001);
}

// Times are compared to the millionth of a second.
TEST(TwoWheelLiftObserver, TakesTheRoundingOfTimesForThatLong) {
    const auto lasts = [](double lasting_s) {
        sil::TwoWheelLiftObserver observer;
        observer.observe({0.0, 0.0, 0.0}, true, false);
        observer.observe({lasting_s, 0.0, 0.0}, true, false);
        return observer.lift_off().has_value();
    };
    EXPECT_TRUE(lasts(0.050 - 1.0e-6));
    EXPECT_FALSE(lasts(0.050 - 1.1e-6));
}

TEST(LoadedSide, IsRightWhereTheLoadTransferIsPositive) {
    EXPECT_EQ(sil::loaded_side(0.01), WarningSide::right);
    EXPECT_EQ(sil::loaded_side(-0.01), WarningSide::left);
    EXPECT_EQ(sil::loaded_side(0.0), WarningSide::none);
    EXPECT_EQ(sil::loaded_side(std::numeric_limits<double>::quiet_NaN()), WarningSide::none);
}

}  // namespace
}  // namespace two_wheel_lift_test
