// Outcome: lift-offs, load transfer and the end of a run, from wheel loads made by hand.
#include <gtest/gtest.h>

#include "sil/studies/campaign/row.hpp"

namespace {

struct Loads {
    double front_left_n;
    double front_right_n;
    double rear_left_n;
    double rear_right_n;
};

class Outcome : public ::testing::Test {
 protected:
    // Advances by this number of steps of 1 ms with these wheel loads.
    void steps(int count, const Loads& loads, double roll_rad = 0.0) {
        for (int step = 0; step < count; ++step) {
            ++time_ms_;
            sil::Truth truth;
            truth.time_s = 0.001 * time_ms_;
            truth.wheel_load_n = {loads.front_left_n, loads.front_right_n, loads.rear_left_n,
                                  loads.rear_right_n};
            truth.roll_angle_rad = roll_rad;
            observer_.observe(truth);
        }
    }
    const sil::Outcome& outcome() const { return observer_.outcome(); }
    bool settled() const { return observer_.settled(); }

    static constexpr Loads level{5000.0, 5000.0, 5000.0, 5000.0};
    static constexpr Loads left_up{0.0, 10000.0, 0.0, 10000.0};
    static constexpr Loads right_up{10000.0, 0.0, 10000.0, 0.0};
    static constexpr Loads diagonal_up{0.0, 10000.0, 10000.0, 0.0};
    static constexpr Loads in_the_air{0.0, 0.0, 0.0, 0.0};

 private:
    sil::OutcomeObserver observer_;
    int time_ms_{0};
};

TEST_F(Outcome, TwoWheelLiftOffIsTheBeginningOfOneThatLasts50Milliseconds) {
    steps(100, level);
    steps(51, left_up);  // from 0.101 to 0.151 s
    ASSERT_TRUE(outcome().two_wheel_lift_time_s);
    EXPECT_NEAR(*outcome().two_wheel_lift_time_s, 0.101, 1.0e-9);
    EXPECT_NEAR(*outcome().one_wheel_lift_time_s, 0.101, 1.0e-9);
    EXPECT_FALSE(outcome().brief_two_wheel_lift_time_s);
}

TEST_F(Outcome, AShorterOneIsBrief) {
    steps(100, level);
    steps(50, right_up);  // from 0.101 to 0.150 s
    steps(10, level);
    EXPECT_FALSE(outcome().two_wheel_lift_time_s);
    EXPECT_NEAR(*outcome().brief_two_wheel_lift_time_s, 0.101, 1.0e-9);
    steps(60, left_up);  // from 0.161 s
    EXPECT_NEAR(*outcome().two_wheel_lift_time_s, 0.161, 1.0e-9);
    EXPECT_NEAR(*outcome().brief_two_wheel_lift_time_s, 0.101, 1.0e-9);
}

TEST_F(Outcome, OneThatTheRunsEndCutsShortIsBrief) {
    steps(100, level);
    steps(20, right_up);
    EXPECT_FALSE(outcome().two_wheel_lift_time_s);
    EXPECT_NEAR(*outcome().brief_two_wheel_lift_time_s, 0.101, 1.0e-9);
}

TEST_F(Outcome, TwoWheelsOfDifferentSidesAreNoTwoWheelLiftOff) {
    steps(200, diagonal_up);
    EXPECT_FALSE(outcome().two_wheel_lift_time_s);
    EXPECT_FALSE(outcome().brief_two_wheel_lift_time_s);
    EXPECT_NEAR(*outcome().one_wheel_lift_time_s, 0.001, 1.0e-9);
}

TEST_F(Outcome, LoadTransferIsTheDifferenceOfTheSidesOverTheSum) {
    steps(10, {2000.0, 6000.0, 1000.0, 11000.0});  // (3000 - 17000) / 20000
    EXPECT_NEAR(outcome().largest_ltr, 0.7, 1.0e-12);
    EXPECT_NEAR(outcome().largest_ltr_before_lift, 0.7, 1.0e-12);
    steps(10, {0.0, 9000.0, 1000.0, 10000.0});  // (1000 - 19000) / 20000, with a wheel in the air
    EXPECT_NEAR(outcome().largest_ltr, 0.9, 1.0e-12);
    EXPECT_NEAR(outcome().largest_ltr_before_lift, 0.7, 1.0e-12);
}

TEST_F(Outcome, LargestLoadTransferStays) {
    steps(10, {2000.0, 6000.0, 1000.0, 11000.0});
    steps(10, level);
    EXPECT_NEAR(outcome().largest_ltr, 0.7, 1.0e-12);
    EXPECT_NEAR(outcome().largest_ltr_before_lift, 0.7, 1.0e-12);
}

TEST_F(Outcome, AWheelThatCarriesAlmostNothingHasNotLifted) {
    steps(10, {0.5, 9999.5, 5000.0, 5000.0});
    EXPECT_FALSE(outcome().one_wheel_lift_time_s);
}

TEST_F(Outcome, WithoutAnyWheelOnTheRoadThereIsNoLoadTransfer) {
    steps(10, in_the_air);
    EXPECT_EQ(outcome().largest_ltr, 0.0);
}

TEST_F(Outcome, IsSettledOnlyWellAfterTwoWheelLiftOffOrOnTheSide) {
    steps(10, level);
    steps(900, left_up, 0.3);
    EXPECT_FALSE(settled());
    EXPECT_FALSE(outcome().rolled_over);
    steps(200, left_up, 0.3);
    EXPECT_TRUE(settled());
    EXPECT_FALSE(outcome().rolled_over);
    steps(1, left_up, -1.05);
    EXPECT_TRUE(outcome().rolled_over);
    EXPECT_NEAR(outcome().end_time_s, 1.111, 1.0e-9);
}

TEST_F(Outcome, IsSettledASecondAfterLiftOffAndNotBefore) {
    steps(1000, left_up);  // from 0.001 to 1.000 s
    EXPECT_FALSE(settled());
    steps(2, left_up);
    EXPECT_TRUE(settled());
}

TEST(OutcomeObserver, IsSettledWhenMoreThanASecondHasPassed) {
    sil::OutcomeObserver observer;
    sil::Truth truth;
    truth.wheel_load_n = {0.0, 10000.0, 0.0, 10000.0};
    for (const double time_s : {1.0, 1.0625, 2.0}) {
        truth.time_s = time_s;
        observer.observe(truth);
    }
    EXPECT_EQ(observer.outcome().two_wheel_lift_time_s, 1.0);
    EXPECT_FALSE(observer.settled());
    truth.time_s = 2.0625;
    observer.observe(truth);
    EXPECT_TRUE(observer.settled());
}

TEST_F(Outcome, HasRolledOverBeyondOneRadianEitherWay) {
    steps(1, level, 1.0);
    EXPECT_FALSE(outcome().rolled_over);
    EXPECT_FALSE(settled());
    steps(1, level, 1.001);
    EXPECT_TRUE(outcome().rolled_over);
    EXPECT_TRUE(settled());
}

TEST_F(Outcome, HasNotRolledOverAtALargeAngleOnTwoWheels) {
    steps(1, left_up, -0.999);
    EXPECT_FALSE(outcome().rolled_over);
    steps(1, left_up, -1.001);
    EXPECT_TRUE(outcome().rolled_over);
}

TEST(OutcomeObserver, KeepsTheLargestOfEitherSide) {
    sil::OutcomeObserver observer;
    EXPECT_EQ(observer.outcome().largest_lateral_acceleration_mps2, 0.0);
    EXPECT_EQ(observer.outcome().largest_roll_angle_rad, 0.0);
    EXPECT_EQ(observer.outcome().largest_ltr_before_lift, 0.0);
    sil::Truth truth;
    for (const double value : {0.1, -0.3, 0.2}) {
        truth.lateral_acceleration_mps2 = 10.0 * value;
        truth.roll_angle_rad = value;
        observer.observe(truth);
    }
    EXPECT_DOUBLE_EQ(observer.outcome().largest_lateral_acceleration_mps2, 3.0);
    EXPECT_DOUBLE_EQ(observer.outcome().largest_roll_angle_rad, 0.3);
}

TEST(OutcomeObserver, AddsUpTheWay) {
    sil::OutcomeObserver observer;
    sil::Truth truth;
    truth.speed_mps = 20.0;
    for (int step = 1; step <= 500; ++step) {
        truth.time_s = 0.001 * step;
        observer.observe(truth);
    }
    EXPECT_NEAR(observer.outcome().distance_m, 10.0, 1.0e-9);
}

TEST_F(Outcome, OfALongCalmRunIsNeverSettled) {
    steps(5000, level);
    EXPECT_FALSE(settled());
    EXPECT_FALSE(outcome().one_wheel_lift_time_s);
}

}  // namespace
