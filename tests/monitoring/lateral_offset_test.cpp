// The memory of minutes for the lateral accelerometer: what it learns, what it corrects, and what teaches it
// nothing.
#include "rsi/ecu/monitoring/lateral_offset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rsi/ecu/monitoring/input_monitor.hpp"
#include "tests/monitoring/leaning_body.hpp"
#include "tests/support/large_suv.h"

namespace monitoring_lateral_offset_test {
namespace {

using rsi::monitoring::DiagnosticCode;
using rsi::monitoring::LateralOffset;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float tolerance_mps2 = 0.4F;
constexpr float limit_mps2 = 1.2F;
constexpr int cycles_in_a_minute = 6000;
constexpr int many = 20 * cycles_in_a_minute;  // ten time constants

// An accelerometer that is wrong by so much to the one reference and to the other.
struct Memory {
    void drive(int cycles, float by_yaw_mps2, float by_roll_mps2) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            const float correction = offset.correction_mps2();
            offset.update(by_yaw_mps2 - correction, by_roll_mps2 - correction);
        }
    }
    void drive(int cycles, float by_both_mps2) { drive(cycles, by_both_mps2, by_both_mps2); }

    LateralOffset offset{};
};

float corrected_after_long(float by_yaw_mps2, float by_roll_mps2) {
    Memory memory;
    memory.drive(many, by_yaw_mps2, by_roll_mps2);
    return memory.offset.correction_mps2();
}

TEST(ALateralOffset, CorrectsNothingUpToItsTolerance) {
    for (const float side : {1.0F, -1.0F}) {
        Memory memory;
        memory.drive(many, side * 0.39F);
        EXPECT_EQ(memory.offset.correction_mps2(), 0.0F);
        EXPECT_EQ(memory.offset.learnt_mps2(), 0.0F);
    }
}

TEST(ALateralOffset, CorrectsAllOfItFromTwiceTheToleranceOn) {
    for (const float size : {2.0F * tolerance_mps2, 1.0F, 1.19F}) {
        EXPECT_NEAR(corrected_after_long(size, size), size, 0.01F);
        EXPECT_NEAR(corrected_after_long(-size, -size), -size, 0.01F);
    }
}

TEST(ALateralOffset, CorrectsTwiceTheExcessBetween) {
    EXPECT_NEAR(corrected_after_long(0.45F, 0.45F), 0.1F, 0.01F);
    EXPECT_NEAR(corrected_after_long(-0.6F, -0.6F), -0.4F, 0.01F);
}

TEST(ALateralOffset, CorrectsNoMoreThanItsLimitAndIsBeyondThen) {
    for (const float side : {1.0F, -1.0F}) {
        Memory memory;
        memory.drive(many, side * 1.19F);
        EXPECT_FALSE(memory.offset.is_beyond());
        memory.drive(many, side * 1.5F);
        EXPECT_TRUE(memory.offset.is_beyond());
        EXPECT_EQ(memory.offset.correction_mps2(), side * limit_mps2);
        memory.drive(many, side * 1.02F);
        EXPECT_TRUE(memory.offset.is_beyond()) << "not before it is clearly less";
        memory.drive(many, side * 0.98F);
        EXPECT_FALSE(memory.offset.is_beyond());
    }
}

// A banked road, a wrong zero of the roll angle.
TEST(ALateralOffset, IsOnlyWhatBothReferencesMissOnTheSameSide) {
    EXPECT_EQ(corrected_after_long(2.0F, 0.0F), 0.0F);
    EXPECT_EQ(corrected_after_long(0.0F, 2.0F), 0.0F);
    EXPECT_EQ(corrected_after_long(1.0F, -1.0F), 0.0F);
    EXPECT_EQ(corrected_after_long(-1.0F, 1.0F), 0.0F);
    EXPECT_NEAR(corrected_after_long(2.0F, 0.8F), 0.8F, 0.01F);
    EXPECT_NEAR(corrected_after_long(-0.8F, -2.0F), -0.8F, 0.01F);
}

// A lag of two minutes: an offset of 1 m/s^2 passes the tolerance after 120 s ln(1 / 0.6).
TEST(ALateralOffset, TakesMinutes) {
    Memory memory;
    memory.drive(6120, 1.0F);
    EXPECT_EQ(memory.offset.correction_mps2(), 0.0F);
    memory.drive(30, 1.0F);
    EXPECT_GT(memory.offset.correction_mps2(), 0.0F);
    memory.drive(5 * cycles_in_a_minute, 1.0F);
    EXPECT_NEAR(memory.offset.correction_mps2(), 0.95F, 0.02F);
    memory.drive(10 * cycles_in_a_minute, 0.0F);
    EXPECT_EQ(memory.offset.correction_mps2(), 0.0F) << "and forgets as it has learnt";
}

TEST(ALateralOffset, TakesAsLongByEitherReference) {
    for (const bool yaw_first : {true, false}) {
        Memory memory;
        memory.drive(many, yaw_first ? 1.0F : 0.0F, yaw_first ? 0.0F : 1.0F);
        memory.drive(6120, 1.0F);
        EXPECT_EQ(memory.offset.correction_mps2(), 0.0F);
        memory.drive(30, 1.0F);
        EXPECT_GT(memory.offset.correction_mps2(), 0.0F);
    }
}

TEST(ALateralOffset, BeginsAtNone) {
    for (const float by_yaw : {0.2F, 2.9F}) {
        Memory memory;
        memory.drive(2000, by_yaw, 3.1F - by_yaw);
        EXPECT_EQ(memory.offset.correction_mps2(), 0.0F);
    }
}

TEST(ALateralOffset, LearnsNearlyStraightOn) {
    for (const float side : {1.0F, -1.0F}) {
        EXPECT_TRUE(LateralOffset::learns_at(side * 1.49F));
        EXPECT_FALSE(LateralOffset::learns_at(side * 1.51F));
    }
    EXPECT_FALSE(LateralOffset::learns_at(nan));
}

TEST(ALateralOffset, LearnsNothingFromASlideOrWhatIsNotAvailable) {
    Memory memory;
    for (const float other : {3.01F, -3.01F, nan}) {
        memory.drive(many, other, 1.0F);
        memory.drive(many, 1.0F, other);
    }
    EXPECT_EQ(memory.offset.correction_mps2(), 0.0F);
    memory.drive(many, 1.0F);
    EXPECT_GT(memory.offset.correction_mps2(), 0.0F);
    memory.drive(many, -2.99F);
    EXPECT_LT(memory.offset.correction_mps2(), 0.0F);
}

TEST(ALateralOffset, GoesOnFromTheTripBefore) {
    for (const float learnt : {1.0F, -1.0F, 2.0F, -3.0F}) {
        LateralOffset offset;
        EXPECT_TRUE(offset.restore(learnt));
        EXPECT_EQ(offset.learnt_mps2(), learnt);
        EXPECT_EQ(offset.correction_mps2(), std::fmin(std::fmax(learnt, -limit_mps2), limit_mps2));
        EXPECT_EQ(offset.is_beyond(), std::fabs(learnt) > limit_mps2);
    }
}

TEST(ALateralOffset, IsNoneOnceItIsWithinTheTolerance) {
    LateralOffset offset;
    EXPECT_TRUE(offset.restore(2.0F));
    EXPECT_TRUE(offset.restore(0.1F));
    EXPECT_FALSE(offset.is_beyond());
    EXPECT_EQ(offset.learnt_mps2(), 0.0F);
    EXPECT_EQ(offset.correction_mps2(), 0.0F);
}

TEST(ALateralOffset, DoesNotGoOnFromWhatIsOutOfRange) {
    LateralOffset offset;
    for (const float wrong : {3.01F, -3.01F, nan, std::numeric_limits<float>::infinity()}) {
        EXPECT_FALSE(offset.restore(wrong));
        EXPECT_EQ(offset.learnt_mps2(), 0.0F);
        EXPECT_EQ(offset.correction_mps2(), 0.0F);
    }
}

// Straight on at 25 m/s with an accelerometer of that offset, every frame fresh; all signals alternate by
// their noise.
class ADrivenAccelerometer : public ::testing::Test {
 protected:
    ADrivenAccelerometer() {
        monitor.start(suv);
        before.state = RSI_STATE_READY;
        before.roll_source = RSI_ROLL_SENSOR;
    }

    void drive(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            const float noise = (cycle % 2 == 0) ? 0.001F : -0.001F;
            rsi::Inputs inputs{};
            inputs.lateral_specific_force_mps2 =
                (is_stuck ? 0.0F : noise) + turn_mps2 + bank_mps2 + offset_mps2;
            inputs.vertical_specific_force_mps2 = rsi::gravity_mps2 + noise;
            inputs.roll_rate_radps = noise;
            inputs.roll_angle_rad =
                noise + monitoring_test::held_roll_angle_rad(suv, turn_mps2 + bank_mps2) + roll_zero_rad;
            inputs.yaw_rate_radps = turn_mps2 / speed_mps + noise;
            inputs.bank_angle_rad = nan;
            inputs.vehicle_mass_kg = nan;
            inputs.speed_mps = speed_mps;
            inputs.steering_wheel_angle_rad = noise;
            qualified = monitor.qualify(inputs, {true, true, true}, before, memory);
            shown_mps2 = inputs.lateral_specific_force_mps2;
        }
    }

    float correction() const { return shown_mps2 - qualified.lateral_specific_force_mps2; }
    bool confirmed() const {
        return memory.confirmed(DiagnosticCode::lateral_acceleration_contradicts_yaw_rate);
    }

    rsi::Parameters suv{rsi_test_large_suv()};
    rsi::monitoring::InputMonitor monitor;
    rsi::monitoring::DiagnosticMemory memory;
    rsi::Outputs before{};
    rsi::Inputs qualified{};
    float offset_mps2{0.0F};
    float bank_mps2{0.0F};
    float turn_mps2{0.0F};
    float speed_mps{25.0F};
    float roll_zero_rad{0.0F};
    float shown_mps2{0.0F};
    bool is_stuck{false};
};

TEST_F(ADrivenAccelerometer, GetsItsAccelerometerCorrected) {
    offset_mps2 = 1.0F;
    drive(10 * cycles_in_a_minute);
    EXPECT_NEAR(correction(), 1.0F, 0.03F);
    EXPECT_EQ(memory.confirmed_codes(), 0U);
}

TEST_F(ADrivenAccelerometer, LosesAnAccelerometerThatIsFurtherOff) {
    offset_mps2 = -1.5F;
    drive(cycles_in_a_minute);
    EXPECT_FALSE(confirmed());
    drive(9 * cycles_in_a_minute);
    EXPECT_TRUE(confirmed());
    EXPECT_TRUE(std::isnan(qualified.lateral_specific_force_mps2));
    offset_mps2 = 0.0F;
    drive(10 * cycles_in_a_minute);
    EXPECT_FALSE(confirmed()) << "it goes on learning, so it finds out";
    EXPECT_EQ(correction(), 0.0F);
}

// The bank of a road without end.
TEST_F(ADrivenAccelerometer, LearnsNothingFromABankThatRollsItsBody) {
    bank_mps2 = 1.0F;
    drive(10 * cycles_in_a_minute);
    EXPECT_EQ(correction(), 0.0F);
}

TEST_F(ADrivenAccelerometer, LearnsNothingFromAWrongZeroOfItsRollAngle) {
    roll_zero_rad = -0.03F;
    drive(10 * cycles_in_a_minute);
    EXPECT_EQ(correction(), 0.0F);
}

// Then the yaw rate decides alone.
TEST_F(ADrivenAccelerometer, LearnsWithoutARollSensor) {
    offset_mps2 = -0.8F;
    roll_zero_rad = nan;
    before.roll_source = RSI_ROLL_OBSERVER;
    drive(10 * cycles_in_a_minute);
    EXPECT_NEAR(correction(), -0.8F, 0.03F);
}

TEST_F(ADrivenAccelerometer, LearnsNothingInATurn) {
    offset_mps2 = 1.0F;
    turn_mps2 = 1.6F;
    drive(10 * cycles_in_a_minute);
    EXPECT_EQ(correction(), 0.0F);
    turn_mps2 = 1.4F;
    drive(10 * cycles_in_a_minute);
    EXPECT_GT(correction(), 0.9F);
}

TEST_F(ADrivenAccelerometer, LearnsNothingWhileItWarnsOrIsSlow) {
    offset_mps2 = 1.0F;
    before.state = RSI_STATE_WARNING;
    drive(10 * cycles_in_a_minute);
    EXPECT_EQ(correction(), 0.0F);
    before.state = RSI_STATE_READY;
    speed_mps = 4.9F;
    drive(10 * cycles_in_a_minute);
    EXPECT_EQ(correction(), 0.0F);
}

TEST_F(ADrivenAccelerometer, LearnsNothingFromASensorThatIsKnownToBeWrong) {
    offset_mps2 = 1.0F;
    for (const DiagnosticCode code : {DiagnosticCode::lateral_acceleration_stuck,
                                      DiagnosticCode::roll_angle_stuck, DiagnosticCode::yaw_rate_stuck,
                                      DiagnosticCode::speed_stuck, DiagnosticCode::roll_angle_reference_wrong,
                                      DiagnosticCode::yaw_rate_contradicts_lateral_acceleration}) {
        monitor = {};
        monitor.start(suv);
        memory = {};
        for (int minute = 0; minute < 10; ++minute) {
            for (int cycle = 0; cycle < cycles_in_a_minute; ++cycle) {
                memory.confirm(code);
                drive(1);
            }
        }
        EXPECT_EQ(monitor.lateral_offset().correction_mps2(), 0.0F) << static_cast<int>(code);
    }
}

// A stall turns no housing.
TEST_F(ADrivenAccelerometer, KeepsWhatIsLearntOverAStall) {
    offset_mps2 = 1.0F;
    drive(10 * cycles_in_a_minute);
    const float corrected = correction();
    monitor.start(suv);
    drive(1);
    EXPECT_NEAR(correction(), corrected, 0.001F);
}

// The correction changes in every cycle, but a value that repeats itself is still one.
TEST_F(ADrivenAccelerometer, FindsAStuckAccelerometerThatIsCorrected) {
    offset_mps2 = 1.0F;
    drive(4 * cycles_in_a_minute);
    ASSERT_GT(correction(), 0.5F);
    is_stuck = true;
    offset_mps2 = 0.8F;
    for (int cycle = 0; cycle < 100; ++cycle) {
        turn_mps2 = 0.02F * static_cast<float>(cycle);
        offset_mps2 = 0.8F - turn_mps2;
        drive(1);
    }
    EXPECT_TRUE(memory.confirmed(DiagnosticCode::lateral_acceleration_stuck));
}

TEST_F(ADrivenAccelerometer, StartsFromWhatTheTripBeforeHasLearnt) {
    EXPECT_TRUE(monitor.restore_offset(-1.0F));
    EXPECT_FALSE(monitor.restore_offset(4.0F));
    offset_mps2 = -1.0F;
    drive(1);
    EXPECT_NEAR(correction(), -1.0F, 0.001F);
}

}  // namespace
}  // namespace monitoring_lateral_offset_test
