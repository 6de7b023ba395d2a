// Whether the roll angle is seen to be measured against the other of road and horizon.
#include "rsi/ecu/monitoring/roll_reference_check.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/large_suv.h"

namespace monitoring_roll_reference_check_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

rsi::monitoring::RollReferenceCheck check_of(rsi_roll_angle_reference reference) {
    rsi_parameters parameters = rsi_test_large_suv();
    parameters.roll_angle_reference = reference;
    rsi::monitoring::RollReferenceCheck check;
    check.start(parameters);
    return check;
}

struct Sample {
    float sensor_rad;
    float observed_roll_rad;
    float bank_rad;
};

bool repeat(rsi::monitoring::RollReferenceCheck& check, int samples, const Sample& sample) {
    for (int k = 0; k < samples; ++k) {
        check.update(sample.sensor_rad, sample.observed_roll_rad, sample.bank_rad);
    }
    return check.contradicts();
}

// On a bank of 0.1 rad, on which the body leans by 0.02.
constexpr Sample against_road{0.02F, 0.02F, 0.1F};
constexpr Sample against_horizon{0.12F, 0.02F, 0.1F};
constexpr Sample against_road_mirrored{-0.02F, -0.02F, -0.1F};
constexpr Sample against_horizon_mirrored{-0.12F, -0.02F, -0.1F};

TEST(RollReferenceCheck, NeedsFiveSecondsOfTheOtherMeaning) {
    for (const Sample& other : {against_horizon, against_horizon_mirrored}) {
        rsi::monitoring::RollReferenceCheck check = check_of(RSI_ROLL_AGAINST_ROAD);
        EXPECT_FALSE(repeat(check, 499, other));
        EXPECT_TRUE(repeat(check, 1, other));
        EXPECT_TRUE(repeat(check, 1000, other));
        EXPECT_TRUE(repeat(check, 1, other));
    }
    for (const Sample& other : {against_road, against_road_mirrored}) {
        rsi::monitoring::RollReferenceCheck check = check_of(RSI_ROLL_AGAINST_HORIZON);
        EXPECT_FALSE(repeat(check, 499, other));
        EXPECT_TRUE(repeat(check, 1, other));
    }
}

TEST(RollReferenceCheck, IsContentWithTheMeaningThatIsSet) {
    rsi::monitoring::RollReferenceCheck road = check_of(RSI_ROLL_AGAINST_ROAD);
    EXPECT_FALSE(repeat(road, 5000, against_road));
    EXPECT_TRUE(road.known());
    rsi::monitoring::RollReferenceCheck horizon = check_of(RSI_ROLL_AGAINST_HORIZON);
    EXPECT_FALSE(repeat(horizon, 5000, against_horizon));
    EXPECT_TRUE(horizon.known());
}

TEST(RollReferenceCheck, TakesOffTheTimeInWhichItAgreed) {
    rsi::monitoring::RollReferenceCheck check = check_of(RSI_ROLL_AGAINST_ROAD);
    EXPECT_FALSE(repeat(check, 400, against_horizon));
    EXPECT_FALSE(repeat(check, 100, against_road));
    EXPECT_FALSE(repeat(check, 199, against_horizon));
    EXPECT_TRUE(repeat(check, 1, against_horizon));
    EXPECT_FALSE(repeat(check, 1, against_road));
    EXPECT_FALSE(repeat(check, 5000, against_road));  // and no further down than to none
    EXPECT_FALSE(repeat(check, 499, against_horizon));
    EXPECT_TRUE(repeat(check, 1, against_horizon));
}

TEST(RollReferenceCheck, SeesNothingWithoutAClearBankOrWithAnAngleBetweenBoth) {
    const Sample nothing[] = {
        {0.049F, 0.0F, 0.049F},    // a bias of the accelerometer may look like that
        {0.0F, 0.0F, 0.049F},      // nor is that a road's
        {0.151F, 0.051F, 0.1F},    // a turn
        {-0.051F, -0.051F, 0.1F},  // one that leans the other way
        {0.071F, 0.02F, 0.1F},     // half of the bank
        {0.051F, 0.02F, 0.1F},     // three tenths
        {0.089F, 0.02F, 0.1F},     // seven
        {0.151F, 0.02F, 0.1F},     // thirteen
        {-0.08F, 0.02F, 0.1F},     // the other way
        {nan, 0.02F, 0.1F},        //
        {0.12F, nan, 0.1F},        //
        {0.12F, 0.02F, nan},       //
    };
    for (const Sample& sample : nothing) {
        for (const auto reference : {RSI_ROLL_AGAINST_ROAD, RSI_ROLL_AGAINST_HORIZON}) {
            rsi::monitoring::RollReferenceCheck check = check_of(reference);
            EXPECT_FALSE(repeat(check, 5000, sample)) << sample.sensor_rad << ' ' << sample.bank_rad;
            EXPECT_FALSE(check.known()) << sample.sensor_rad << ' ' << sample.bank_rad;
        }
    }
    for (const Sample& sample : {Sample{0.051F, 0.0F, 0.051F}, Sample{0.149F, 0.049F, 0.1F},
                                 Sample{0.091F, 0.02F, 0.1F}, Sample{0.149F, 0.02F, 0.1F}}) {
        rsi::monitoring::RollReferenceCheck check = check_of(RSI_ROLL_AGAINST_ROAD);
        EXPECT_TRUE(repeat(check, 500, sample)) << sample.sensor_rad << ' ' << sample.bank_rad;
    }
    for (const Sample& sample : {Sample{0.049F, 0.02F, 0.1F}, Sample{-0.009F, 0.02F, 0.1F},
                                 Sample{-0.049F, -0.049F, 0.1F}, Sample{0.0F, 0.0F, 0.051F}}) {
        rsi::monitoring::RollReferenceCheck check = check_of(RSI_ROLL_AGAINST_HORIZON);
        EXPECT_TRUE(repeat(check, 500, sample)) << sample.sensor_rad << ' ' << sample.bank_rad;
    }
}

TEST(RollReferenceCheck, AStartForgetsWhatWasSeen) {
    rsi::monitoring::RollReferenceCheck check = check_of(RSI_ROLL_AGAINST_ROAD);
    repeat(check, 500, against_horizon);
    check.start(rsi_test_large_suv());
    EXPECT_FALSE(check.contradicts());
    EXPECT_FALSE(check.known());
    EXPECT_FALSE(repeat(check, 499, against_horizon));
}

}  // namespace
}  // namespace monitoring_roll_reference_check_test
