// Isolation by the input monitor when two sensors contradict each other, and the signals that it invalidates.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rsi/ecu/monitoring/input_monitor.hpp"
#include "tests/monitoring/leaning_body.hpp"
#include "tests/support/large_suv.h"

namespace monitoring_input_monitor_test {
namespace {

using rsi::monitoring::DiagnosticCode;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// Straight on at 30 m/s, every frame fresh, the component content.
class AnInputMonitor : public ::testing::Test {
 protected:
    AnInputMonitor() {
        monitor.start(rsi_test_large_suv());
        inputs.lateral_specific_force_mps2 = 0.0F;
        inputs.vertical_specific_force_mps2 = 9.80665F;
        inputs.roll_rate_radps = 0.0F;
        inputs.roll_angle_rad = 0.0F;
        inputs.yaw_rate_radps = 0.0F;
        inputs.bank_angle_rad = nan;
        inputs.vehicle_mass_kg = nan;
        inputs.speed_mps = 30.0F;
        inputs.steering_wheel_angle_rad = 0.0F;
        before.state = RSI_STATE_READY;
        before.roll_source = RSI_ROLL_SENSOR;
    }

    void start_anew(const rsi::Parameters& parameters) {
        memory = {};
        monitor = {};
        monitor.start(parameters);
    }

    void turn_at(float lateral_mps2) {
        inputs.lateral_specific_force_mps2 = lateral_mps2;
        inputs.yaw_rate_radps = lateral_mps2 / inputs.speed_mps;
    }

    // Roll angle and roll rate go on by so much each cycle; both have a noise of one part in a thousand,
    // unless they are frozen.
    void roll(int cycles, float rise_per_cycle_rad, float roll_rate_radps, bool angle_frozen = false,
              bool rate_frozen = false) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            const float noise = (cycle % 2 == 0) ? 0.001F : -0.001F;
            angle_rad += rise_per_cycle_rad;
            inputs.roll_angle_rad = angle_rad + (angle_frozen ? 0.0F : noise);
            inputs.roll_rate_radps = roll_rate_radps + (rate_frozen ? 0.0F : noise);
            run(1);
        }
    }

    void run(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            rsi::monitoring::FreshFrames fresh{true, true, true};
            rsi::Inputs received = inputs;
            if (angle_is_held_back) {
                fresh.roll_angle = false;
                fresh.late_roll_angle_rad = inputs.roll_angle_rad;
                received.roll_angle_rad = nan;
            }
            qualified = monitor.qualify(received, fresh, before, memory);
        }
    }

    void hold_back_the_angle() { angle_is_held_back = true; }

    bool confirmed(DiagnosticCode code) const { return memory.confirmed(code); }

    static constexpr DiagnosticCode roll_sensor_code = DiagnosticCode::roll_sensor_contradicts_observer;
    static constexpr DiagnosticCode lateral_code = DiagnosticCode::lateral_acceleration_contradicts_yaw_rate;
    static constexpr DiagnosticCode yaw_code = DiagnosticCode::yaw_rate_contradicts_lateral_acceleration;
    static constexpr DiagnosticCode reference_code = DiagnosticCode::roll_angle_reference_wrong;
    static constexpr DiagnosticCode roll_code = DiagnosticCode::roll_rate_contradicts_roll_angle;

    rsi::monitoring::InputMonitor monitor;
    rsi::monitoring::DiagnosticMemory memory;
    rsi::Inputs inputs{};
    rsi::Outputs before{};
    rsi::Inputs qualified{};
    float angle_rad{0.0F};
    bool angle_is_held_back{false};
};

TEST_F(AnInputMonitor, PassesOnSignalsWithoutAContradiction) {
    run(1000);
    EXPECT_EQ(qualified.lateral_specific_force_mps2, inputs.lateral_specific_force_mps2);
    EXPECT_EQ(qualified.vertical_specific_force_mps2, inputs.vertical_specific_force_mps2);
    EXPECT_EQ(qualified.roll_rate_radps, inputs.roll_rate_radps);
    EXPECT_EQ(qualified.roll_angle_rad, inputs.roll_angle_rad);
    EXPECT_EQ(qualified.yaw_rate_radps, inputs.yaw_rate_radps);
    EXPECT_EQ(qualified.speed_mps, inputs.speed_mps);
    EXPECT_EQ(qualified.steering_wheel_angle_rad, inputs.steering_wheel_angle_rad);
    EXPECT_EQ(memory.next().code, DiagnosticCode::none);
}

// A vehicle that slides under a load: its yaw rate leads, and its body rolls as the empty one under that
// force.
TEST_F(AnInputMonitor, TakesALoadThatMinutesHaveShownForNoFaultOfTheAccelerometer) {
    rsi::Parameters suv = rsi_test_large_suv();
    suv.load_adaptation = 1.0F;
    monitor.start(suv);
    inputs.lateral_specific_force_mps2 = 4.0F;
    inputs.yaw_rate_radps = 8.0F / inputs.speed_mps;
    inputs.roll_angle_rad = monitoring_test::held_roll_angle_rad(suv, 8.0F);
    before.load_excess = 1.0F;
    before.load_excess_deviation = 0.059F;
    run(200);
    EXPECT_FALSE(confirmed(lateral_code));
    const rsi::Outputs stated = before;
    before.load_excess = nan;  // without a statement what was known stays
    before.load_excess_deviation = nan;
    run(200);
    EXPECT_FALSE(confirmed(lateral_code));
    before = stated;
    before.load_excess_deviation = 0.06F;  // an accelerometer that has just failed looks like a load, too
    run(200);
    EXPECT_TRUE(confirmed(lateral_code));
}

// Onto a bank of 12 deg within a second, straight on: the body leans against the road as its weight makes it.
TEST_F(AnInputMonitor, TakesARoadThatTwistsForNoFaultOfTheRollRate) {
    const rsi::Parameters suv = rsi_test_large_suv();
    for (const float seen : {1.0F, 0.0F}) {
        float bank_rad = 0.0F;
        for (int cycle = 0; cycle < 300; ++cycle) {
            const bool twists = cycle >= 100 && cycle < 200;
            bank_rad += twists ? 0.0021F : 0.0F;
            const float noise = (cycle % 2 == 0) ? 0.001F : -0.001F;
            inputs.lateral_specific_force_mps2 = seen * 9.80665F * std::sin(bank_rad) + noise;
            inputs.roll_angle_rad =
                monitoring_test::held_roll_angle_rad(suv, inputs.lateral_specific_force_mps2);
            inputs.roll_rate_radps = (twists ? 0.21F : 0.0F) + noise;
            run(1);
        }
        EXPECT_EQ(confirmed(DiagnosticCode::roll_rate_offset), seen < 1.0F);
        EXPECT_FALSE(confirmed(lateral_code));
        monitor.start(suv);
    }
}

// Wheels that come down again.
TEST_F(AnInputMonitor, AdmitsAVerticalAccelerationThatChangesBy12MetresPerSecondSquaredInACycle) {
    run(10);
    inputs.vertical_specific_force_mps2 += 11.9F;
    run(1);
    EXPECT_EQ(qualified.vertical_specific_force_mps2, inputs.vertical_specific_force_mps2);
    run(50);
    inputs.vertical_specific_force_mps2 -= 12.1F;
    run(1);
    EXPECT_TRUE(std::isnan(qualified.vertical_specific_force_mps2));
}

// Both axles over a hump, again and again.
TEST_F(AnInputMonitor, TakesHumpsForNoFaultOfTheVerticalAcceleration) {
    run(10);
    const float level_mps2 = inputs.vertical_specific_force_mps2;
    for (int hump = 0; hump < 10; ++hump) {
        for (const float heave_mps2 : {7.0F, 7.0F, -4.0F, -4.0F, 0.0F}) {
            inputs.vertical_specific_force_mps2 = level_mps2 + heave_mps2;
            run(5);
        }
        run(100);
    }
    EXPECT_FALSE(confirmed(DiagnosticCode::vertical_acceleration_jump));
}

// A wheel over a bump shakes the roll as well; noise of the accelerometer alone is a fault.
TEST_F(AnInputMonitor, AdmitsAVerticalAccelerationThatIsShakenWithTheRollRate) {
    for (const float rate_radps : {0.0F, 0.02F}) {
        memory = {};
        monitor.start(rsi_test_large_suv());
        for (int cycle = 0; cycle < 100; ++cycle) {
            const float sign = (cycle % 2 == 0) ? 1.0F : -1.0F;
            inputs.vertical_specific_force_mps2 = 9.80665F + sign * 0.9F;  // 3.6 of second difference
            inputs.roll_rate_radps = sign * rate_radps;                    // 0.08
            run(1);
        }
        EXPECT_EQ(confirmed(DiagnosticCode::vertical_acceleration_jump), rate_radps < 0.01F);
    }
}

// In the air and after the landing the body has no heave that a model could use.
TEST_F(AnInputMonitor, NeitherUsesNorJudgesTheVerticalAccelerationOfAJump) {
    run(10);
    inputs.vertical_specific_force_mps2 = 0.0F;
    run(4);
    EXPECT_EQ(qualified.vertical_specific_force_mps2, 9.80665F);
    run(46);
    EXPECT_TRUE(std::isnan(qualified.vertical_specific_force_mps2));
    inputs.vertical_specific_force_mps2 = 60.0F;
    run(10);
    inputs.vertical_specific_force_mps2 = 9.80665F;
    run(89);
    EXPECT_TRUE(std::isnan(qualified.vertical_specific_force_mps2));
    run(1);
    EXPECT_EQ(qualified.vertical_specific_force_mps2, inputs.vertical_specific_force_mps2);
    EXPECT_EQ(memory.next().code, DiagnosticCode::none);
}

// One that has failed at zero.
TEST_F(AnInputMonitor, BlamesAVerticalAccelerationThatIsZeroForLongerThanAJump) {
    inputs.vertical_specific_force_mps2 = 0.0F;
    run(100);
    EXPECT_FALSE(confirmed(DiagnosticCode::vertical_acceleration_offset));
    run(3);
    EXPECT_TRUE(confirmed(DiagnosticCode::vertical_acceleration_offset));
}

// From the standstill backwards into a turn.
TEST_F(AnInputMonitor, DoesNotBlameTheYawRateOfAVehicleInReverse) {
    const rsi::Parameters suv = rsi_test_large_suv();
    for (const bool stood : {true, false}) {
        start_anew(suv);
        turn_at(0.0F);
        inputs.speed_mps = stood ? 0.5F : 2.0F;
        inputs.roll_angle_rad = 0.0F;
        run(1);
        while (inputs.speed_mps < 9.0F) {
            inputs.speed_mps += 1.0F;
            run(1);
        }
        monitor.start(suv);  // after a stall
        inputs.lateral_specific_force_mps2 = 2.5F;
        inputs.yaw_rate_radps = -2.5F / inputs.speed_mps;
        inputs.roll_angle_rad = monitoring_test::held_roll_angle_rad(suv, 2.5F);
        run(300);
        EXPECT_EQ(confirmed(yaw_code), !stood);
        EXPECT_FALSE(confirmed(lateral_code));
        inputs.speed_mps = 30.0F;
    }
}

// Yaw rate and roll angle agree against the accelerometer; but in a spin the yaw rate is no reference.
TEST_F(AnInputMonitor, SetsNoCodeOfTheAccelerometerInASpin) {
    const rsi::Parameters suv = rsi_test_large_suv();
    inputs.lateral_specific_force_mps2 = 0.0F;
    angle_rad = inputs.roll_angle_rad = monitoring_test::held_roll_angle_rad(suv, 8.5F);
    ASSERT_LT(angle_rad, 0.15F);
    inputs.yaw_rate_radps = 10.6F / inputs.speed_mps;
    run(60);
    EXPECT_FALSE(confirmed(lateral_code));
    inputs.yaw_rate_radps = 10.0F / inputs.speed_mps;
    run(200);  // a second after the spin
    EXPECT_TRUE(confirmed(lateral_code));
}

// 9 m/s^2 of yaw rate times speed while the vehicle goes straight: with a lag of 4 s, 7 m/s^2 after 6.0 s.
TEST_F(AnInputMonitor, InvalidatesAYawRateThatNoSlideExplains) {
    inputs.yaw_rate_radps = 0.3F;
    run(595);
    EXPECT_FALSE(confirmed(yaw_code));
    EXPECT_EQ(qualified.yaw_rate_radps, 0.3F);
    run(12);
    EXPECT_TRUE(confirmed(yaw_code));
    EXPECT_TRUE(std::isnan(qualified.yaw_rate_radps));
    EXPECT_EQ(qualified.lateral_specific_force_mps2, 0.0F);
    EXPECT_FALSE(confirmed(lateral_code));

    inputs.yaw_rate_radps = 0.15F;
    run(10);
    inputs.yaw_rate_radps = 0.0F;  // from here on they agree
    run(99);
    EXPECT_TRUE(std::isnan(qualified.yaw_rate_radps));
    run(1);
    EXPECT_EQ(qualified.yaw_rate_radps, 0.0F);
}

TEST_F(AnInputMonitor, BlamesTheRollSensorForWhatTheObserverContradicts) {
    inputs.roll_angle_rad = 0.04F;  // without a force
    run(100);
    before.roll_sensor_disagrees = 1;
    run(1);
    EXPECT_TRUE(confirmed(roll_sensor_code));
    EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
    EXPECT_FALSE(confirmed(lateral_code));
    EXPECT_EQ(qualified.lateral_specific_force_mps2, 0.0F);
}

// On a road that twists the observer takes the bank's rate for the body's.
TEST_F(AnInputMonitor, DoesNotBlameARollSensorThatTheForceConfirms) {
    const rsi::Parameters suv = rsi_test_large_suv();
    turn_at(4.0F);
    inputs.roll_angle_rad = monitoring_test::held_roll_angle_rad(suv, 4.0F);
    run(100);
    before.roll_sensor_disagrees = 1;
    run(100);
    EXPECT_FALSE(confirmed(roll_sensor_code));
    inputs.yaw_rate_radps = 0.0F;  // nor the accelerometer, for a bank or a slide
    run(100);
    EXPECT_FALSE(confirmed(lateral_code));
}

TEST_F(AnInputMonitor, BlamesTheAccelerometerWhenTheYawRateContradictsItToo) {
    inputs.lateral_specific_force_mps2 = 2.5F;
    run(100);
    EXPECT_FALSE(confirmed(lateral_code));
    before.roll_sensor_disagrees = 1;
    run(1);
    EXPECT_TRUE(confirmed(lateral_code));
    EXPECT_TRUE(std::isnan(qualified.lateral_specific_force_mps2));
    EXPECT_FALSE(confirmed(roll_sensor_code));
    EXPECT_EQ(qualified.roll_angle_rad, 0.0F);
}

TEST_F(AnInputMonitor, SetsNoCodeForASymptomOfTheYawRateAlone) {
    inputs.lateral_specific_force_mps2 = 2.5F;
    run(1000);
    EXPECT_FALSE(confirmed(lateral_code));
    EXPECT_FALSE(confirmed(roll_sensor_code));
    EXPECT_FALSE(confirmed(yaw_code));
}

TEST_F(AnInputMonitor, DoesNotUseTheObserverInASpin) {
    turn_at(10.6F);
    before.roll_sensor_disagrees = 1;
    run(100);
    EXPECT_FALSE(confirmed(roll_sensor_code));
    turn_at(10.4F);
    run(99);
    EXPECT_FALSE(confirmed(roll_sensor_code));
    run(1);
    EXPECT_TRUE(confirmed(roll_sensor_code));
}

// Without a roll sensor there is nothing to contradict, whatever the component has said of it before.
TEST_F(AnInputMonitor, DoesNotBlameARollSensorThatSaysNothing) {
    inputs.roll_angle_rad = nan;
    before.roll_sensor_disagrees = 1;
    run(100);
    EXPECT_FALSE(confirmed(roll_sensor_code));
}

TEST_F(AnInputMonitor, LetsARollSensorThatIsOutComeBackOnlyWithin50MilliradiansOfTheObserver) {
    before.roll_source = RSI_ROLL_OBSERVER;
    for (const float sign : {1.0F, -1.0F}) {
        before.observed_roll_angle_rad = sign * 0.049F;
        run(100);
        EXPECT_FALSE(confirmed(roll_sensor_code));
    }
    before.observed_roll_angle_rad = 0.051F;
    run(1);
    EXPECT_TRUE(confirmed(roll_sensor_code));
}

TEST_F(AnInputMonitor, TakesTheRollSensorBackAfterASecondWithin25MilliradiansOfTheObserver) {
    inputs.roll_angle_rad = 0.04F;
    run(100);
    before.roll_sensor_disagrees = 1;
    run(1);
    ASSERT_TRUE(confirmed(roll_sensor_code));
    before.roll_sensor_disagrees = 0;
    inputs.roll_angle_rad = 0.0F;
    before.observed_roll_angle_rad = 0.026F;
    run(500);
    EXPECT_TRUE(confirmed(roll_sensor_code));
    before.observed_roll_angle_rad = -0.024F;
    run(99);
    EXPECT_TRUE(confirmed(roll_sensor_code));
    run(1);
    EXPECT_FALSE(confirmed(roll_sensor_code));
    EXPECT_EQ(qualified.roll_angle_rad, 0.0F);
}

// Neither good nor bad: half a second, then a gap, then half a second heal it.
TEST_F(AnInputMonitor, DoesNotJudgeTheRollSensorWhileEitherSaysNothing) {
    inputs.roll_angle_rad = 0.04F;
    run(100);
    before.roll_sensor_disagrees = 1;
    run(1);
    ASSERT_TRUE(confirmed(roll_sensor_code));
    before.roll_sensor_disagrees = 0;
    inputs.roll_angle_rad = 0.0F;
    run(50);
    before.observed_roll_angle_rad = nan;
    run(300);
    EXPECT_TRUE(confirmed(roll_sensor_code));
    before.observed_roll_angle_rad = 0.0F;
    run(49);
    EXPECT_TRUE(confirmed(roll_sensor_code));
    run(1);
    EXPECT_FALSE(confirmed(roll_sensor_code));
}

// Inputs of a roll angle and a roll rate that come apart by 4.6 deg in 0.2 s, in a turn to the left.
TEST_F(AnInputMonitor, BlamesARollAngleThatLeansIntoTheTurn) {
    turn_at(3.0F);
    roll(40, -0.004F, 0.0F);
    EXPECT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
    EXPECT_EQ(qualified.roll_rate_radps, inputs.roll_rate_radps);
}

TEST_F(AnInputMonitor, BlamesTheRollRateWhenTheAngleLeansOutOfTheTurn) {
    turn_at(3.0F);
    roll(40, 0.004F, 0.0F);
    EXPECT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_rate_radps));
    EXPECT_EQ(qualified.roll_angle_rad, inputs.roll_angle_rad);
}

TEST_F(AnInputMonitor, BlamesTheRollRateWhenTheForceSaysNothingOfTheAngle) {
    turn_at(1.9F);
    roll(40, -0.004F, 0.0F);
    EXPECT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_rate_radps));
    EXPECT_EQ(qualified.roll_angle_rad, inputs.roll_angle_rad);
}

TEST_F(AnInputMonitor, KeepsToWhomItHasBlamed) {
    turn_at(3.0F);
    roll(40, -0.004F, 0.0F);
    ASSERT_TRUE(std::isnan(qualified.roll_angle_rad));
    roll(45, 0.0045F, 0.0F);  // now leans out of it
    EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
    EXPECT_EQ(qualified.roll_rate_radps, inputs.roll_rate_radps);
}

TEST_F(AnInputMonitor, BlamesTheOneOfTheTwoThatRepeatsItself) {
    turn_at(3.0F);
    roll(40, 0.0F, 0.4F, true, false);
    EXPECT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
    EXPECT_EQ(qualified.roll_rate_radps, inputs.roll_rate_radps);

    monitor.start(rsi_test_large_suv());
    memory = {};
    angle_rad = 0.0F;
    roll(40, -0.004F, 0.0F, false, true);
    EXPECT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_rate_radps));
    EXPECT_EQ(qualified.roll_angle_rad, inputs.roll_angle_rad);
}

// A turn to the left by yaw rate and roll angle, to the right by the accelerometer, too weak for other votes.
TEST_F(AnInputMonitor, BlamesAnAccelerometerOfTheWrongSignAfter200Milliseconds) {
    turn_at(2.1F);
    inputs.lateral_specific_force_mps2 = -2.1F;
    inputs.roll_angle_rad = 0.03F;
    run(19);
    EXPECT_FALSE(confirmed(lateral_code));
    run(1);
    EXPECT_TRUE(confirmed(lateral_code));
    EXPECT_TRUE(std::isnan(qualified.lateral_specific_force_mps2));
    EXPECT_FALSE(confirmed(yaw_code));
}

TEST_F(AnInputMonitor, BlamesAYawRateOfTheWrongSignAfter1200Milliseconds) {
    turn_at(2.1F);
    inputs.yaw_rate_radps = -inputs.yaw_rate_radps;
    inputs.roll_angle_rad = 0.03F;
    run(119);
    EXPECT_FALSE(confirmed(yaw_code));
    run(1);
    EXPECT_TRUE(confirmed(yaw_code));
    EXPECT_TRUE(std::isnan(qualified.yaw_rate_radps));
    EXPECT_FALSE(confirmed(lateral_code));
}

TEST_F(AnInputMonitor, DoesNotJudgeATurnBelow5MetresASecond) {
    inputs.speed_mps = 4.9F;
    turn_at(2.5F);
    inputs.lateral_specific_force_mps2 = -2.5F;
    inputs.roll_angle_rad = 0.03F;
    run(1000);
    EXPECT_FALSE(confirmed(lateral_code));
    EXPECT_FALSE(confirmed(yaw_code));
}

TEST_F(AnInputMonitor, TakesAccelerometerAndYawRateBackAtRestToo) {
    for (const float sign : {1.0F, -1.0F}) {  // of the yaw rate: with the roll angle, or against it
        monitor.start(rsi_test_large_suv());
        memory = {};
        inputs.speed_mps = 30.0F;
        turn_at(sign * 2.5F);
        inputs.lateral_specific_force_mps2 = sign * -2.5F;
        inputs.roll_angle_rad = 0.03F;
        run(150);
        const DiagnosticCode code = sign > 0.0F ? lateral_code : yaw_code;
        ASSERT_TRUE(confirmed(code));
        inputs.speed_mps = 0.0F;
        run(200);
        EXPECT_TRUE(confirmed(code));  // 2.5 m/s^2 are too much for a vehicle at rest
        turn_at(0.0F);
        inputs.yaw_rate_radps = 0.0F;
        run(99);
        EXPECT_TRUE(confirmed(code));
        run(1);
        EXPECT_FALSE(confirmed(code));
    }
}

// From the moment on in which it is fast enough.
TEST_F(AnInputMonitor, CountsTheSignsOfATurnAbove5MetresASecondOnly) {
    inputs.speed_mps = 4.9F;
    turn_at(2.5F);
    inputs.lateral_specific_force_mps2 = -2.5F;
    inputs.roll_angle_rad = 0.03F;
    run(100);
    inputs.speed_mps = 5.1F;
    run(19);
    EXPECT_FALSE(confirmed(lateral_code));
    run(1);
    EXPECT_TRUE(confirmed(lateral_code));
}

// The observer's model is no reference for the accelerometer in the moment in which the roll sensor
// returns.
TEST_F(AnInputMonitor, BlamesOnlyARollSensorThatComesBackForWhatTheObserverContradicts) {
    inputs.lateral_specific_force_mps2 = 2.1F;
    run(100);
    before.roll_source = RSI_ROLL_OBSERVER;
    before.observed_roll_angle_rad = 0.06F;
    run(1);
    EXPECT_TRUE(confirmed(roll_sensor_code));
    EXPECT_FALSE(confirmed(lateral_code));
    EXPECT_EQ(qualified.lateral_specific_force_mps2, 2.1F);
}

TEST_F(AnInputMonitor, TakesTheAccelerometerBackAfterASecondWithin2MetresPerSecondSquaredOfTheTurn) {
    inputs.lateral_specific_force_mps2 = 2.1F;
    run(100);
    before.roll_sensor_disagrees = 1;
    run(1);
    ASSERT_TRUE(confirmed(lateral_code));
    before.roll_sensor_disagrees = 0;
    run(500);
    EXPECT_TRUE(confirmed(lateral_code));
    inputs.lateral_specific_force_mps2 = 1.9F;
    run(99);
    EXPECT_TRUE(confirmed(lateral_code));
    EXPECT_TRUE(std::isnan(qualified.lateral_specific_force_mps2));
    run(1);
    EXPECT_FALSE(confirmed(lateral_code));
    EXPECT_EQ(qualified.lateral_specific_force_mps2, 1.9F);
}

// 10 m/s^2 too much: with a lag of 0.3 s it has stood against the two others for 0.36 s more once it agrees.
TEST_F(AnInputMonitor, TakesTheAccelerometerBackASecondAfterItsMeanAgreesToo) {
    inputs.lateral_specific_force_mps2 = 10.0F;
    run(200);
    ASSERT_TRUE(confirmed(lateral_code));
    inputs.lateral_specific_force_mps2 = 0.0F;
    run(130);
    EXPECT_TRUE(confirmed(lateral_code));
    run(10);
    EXPECT_FALSE(confirmed(lateral_code));
}

// Nothing is said of the two while either is missing: neither that they contradict each other, nor that they
// do not.
TEST_F(AnInputMonitor, DoesNotHealRollRateAndRollAngleByTheirAbsence) {
    turn_at(3.0F);
    roll(40, -0.004F, 0.0F);
    ASSERT_TRUE(confirmed(roll_code));
    const float last_rad = inputs.roll_angle_rad;
    inputs.roll_angle_rad = nan;
    run(500);
    EXPECT_TRUE(confirmed(roll_code));
    inputs.roll_angle_rad = last_rad;
    run(120);  // 4 until it is trusted, 20 until the two are compared, 100
    EXPECT_TRUE(confirmed(roll_code));
    run(10);
    EXPECT_FALSE(confirmed(roll_code));
}

// A gyro's offset goes on for hours; in a vehicle at rest an angle of few digits repeats itself, and so does
// the gyro.
TEST_F(AnInputMonitor, CallsNoSensorStuckForTheOffsetOfAGyro) {
    inputs.speed_mps = 0.0F;
    inputs.roll_angle_rad = 0.01F;
    for (const float offset_radps : {0.0096F, -0.0096F}) {  // 0.55 deg/s
        monitor.start(rsi_test_large_suv());
        for (int cycle = 0; cycle < 100000; ++cycle) {  // 5 rad and on
            inputs.roll_rate_radps = offset_radps + (cycle % 2 == 0 ? 0.001F : -0.001F);
            run(1);
        }
        inputs.roll_rate_radps = offset_radps;
        run(100000);
        EXPECT_FALSE(confirmed(DiagnosticCode::roll_angle_stuck));
        EXPECT_FALSE(confirmed(DiagnosticCode::roll_rate_stuck));
    }
}

// Short enough to see how much is allowed: 0.01 rad/s beyond the first second.
TEST_F(AnInputMonitor, CallsARollSensorStuckForMoreThanTheOffsetOfAGyro) {
    for (const float sign : {1.0F, -1.0F}) {
        for (const float rate_radps : {0.0096F, 0.0104F}) {
            monitor.start(rsi_test_large_suv());
            memory = {};
            inputs.speed_mps = 0.0F;
            inputs.roll_angle_rad = 0.01F;
            inputs.roll_rate_radps = sign * rate_radps;
            run(3000);
            EXPECT_EQ(confirmed(DiagnosticCode::roll_angle_stuck), rate_radps > 0.01F);
            EXPECT_EQ(confirmed(DiagnosticCode::roll_rate_stuck), rate_radps > 0.01F);
        }
    }
}

// It comes late; but if it fits nevertheless, the roll rate is cleared.
TEST_F(AnInputMonitor, HealsRollRateAndRollAngleByAnAngleThatIsHeldBack) {
    turn_at(3.0F);
    roll(40, 0.004F, 0.0F);
    ASSERT_TRUE(confirmed(roll_code));
    hold_back_the_angle();
    roll(120, 0.0F, 0.0F);
    EXPECT_FALSE(confirmed(roll_code));
    EXPECT_EQ(qualified.roll_rate_radps, inputs.roll_rate_radps);
    EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
}

TEST_F(AnInputMonitor, DoesNotHealByAnAngleThatIsHeldBackAndContradicts) {
    turn_at(3.0F);
    roll(40, 0.004F, 0.0F);
    ASSERT_TRUE(confirmed(roll_code));
    hold_back_the_angle();
    roll(500, 0.004F, 0.0F);
    EXPECT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_rate_radps));
}

TEST_F(AnInputMonitor, SetsNoCodeForAnAngleThatIsHeldBack) {
    turn_at(3.0F);
    hold_back_the_angle();
    roll(500, 0.004F, 0.0F);
    EXPECT_FALSE(confirmed(roll_code));
    EXPECT_FALSE(confirmed(DiagnosticCode::roll_rate_offset));
    EXPECT_EQ(qualified.roll_rate_radps, inputs.roll_rate_radps);
}

TEST_F(AnInputMonitor, BlamesARollAngleThatLeansIntoATurnOfMoreThan2MetresPerSecondSquared) {
    for (const float sign : {1.0F, -1.0F}) {
        monitor.start(rsi_test_large_suv());
        memory = {};
        angle_rad = 0.0F;
        turn_at(sign * 2.05F);
        roll(40, sign * -0.004F, 0.0F);
        EXPECT_TRUE(confirmed(roll_code));
        EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
        EXPECT_EQ(qualified.roll_rate_radps, inputs.roll_rate_radps);
    }
}

// After a stall it starts anew, but the code is still there.
TEST_F(AnInputMonitor, KeepsToWhomItHasBlamedOverAStart) {
    turn_at(3.0F);
    roll(40, 0.004F, 0.0F);
    ASSERT_TRUE(confirmed(roll_code));
    monitor.start(rsi_test_large_suv());
    roll(50, 0.004F, 0.0F);
    ASSERT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_rate_radps));
    EXPECT_EQ(qualified.roll_angle_rad, inputs.roll_angle_rad);
}

// With any other fault.
TEST_F(AnInputMonitor, TakesTheRollRateBackOnceTheContradictionHasHealed) {
    turn_at(3.0F);
    roll(40, 0.004F, 0.0F);
    ASSERT_TRUE(confirmed(roll_code));
    ASSERT_TRUE(std::isnan(qualified.roll_rate_radps));
    inputs.steering_wheel_angle_rad = nan;
    roll(300, 0.0F, 0.0F);
    EXPECT_FALSE(confirmed(roll_code));
    EXPECT_EQ(qualified.roll_rate_radps, inputs.roll_rate_radps);
    EXPECT_EQ(qualified.roll_angle_rad, inputs.roll_angle_rad);
    EXPECT_TRUE(confirmed(DiagnosticCode::steering_invalid));
}

// While the yaw rate alone is ahead, as in a weave near the limit, an accelerometer with a code is shown
// to be neither good nor bad: its second is interrupted and goes on. A roll angle that contradicts it as well
// by more than half of the limit lets the second begin anew.
TEST_F(AnInputMonitor, LetsAnAccelerometersSecondWaitWhileTheYawRateAloneIsAhead) {
    const rsi::Parameters suv = rsi_test_large_suv();
    const auto cycles_to_heal = [this, &suv](float roll_contradicts_by_mps2, int ahead_cycles) {
        monitor.start(suv);
        memory = {};
        turn_at(4.0F);
        inputs.roll_angle_rad = monitoring_test::held_roll_angle_rad(suv, 4.0F);
        run(100);
        inputs.lateral_specific_force_mps2 = 9.0F;
        run(50);
        EXPECT_TRUE(confirmed(lateral_code));
        inputs.lateral_specific_force_mps2 = 4.0F;
        inputs.roll_angle_rad = monitoring_test::held_roll_angle_rad(suv, 4.0F - roll_contradicts_by_mps2);
        run(100);
        EXPECT_TRUE(confirmed(lateral_code));
        inputs.yaw_rate_radps = 7.0F / inputs.speed_mps;
        run(ahead_cycles);
        turn_at(4.0F);
        int cycles = 100 + ahead_cycles;
        for (; confirmed(lateral_code) && cycles < 1000; ++cycles) {
            run(1);
        }
        return cycles;
    };
    for (const float sign : {1.0F, -1.0F}) {
        EXPECT_EQ(cycles_to_heal(sign * 1.3F, 30), cycles_to_heal(sign * 1.3F, 0) + 30);
        EXPECT_EQ(cycles_to_heal(sign * 1.75F, 30), 100 + 30 + 100);
    }
}

// On a bank of 0.1 rad, the body upright on it.
TEST_F(AnInputMonitor, InvalidatesARollAngleWithAWrongReferenceUntilItIsRightForFiveSeconds) {
    before.observed_bank_angle_rad = 0.1F;
    inputs.roll_angle_rad = 0.1F;
    run(499);
    EXPECT_FALSE(confirmed(reference_code));
    EXPECT_EQ(qualified.roll_angle_rad, 0.1F);
    run(1);
    EXPECT_TRUE(confirmed(reference_code));
    EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
    before.observed_bank_angle_rad = 0.0F;  // a level road shows nothing
    inputs.roll_angle_rad = 0.0F;
    run(1000);
    EXPECT_TRUE(confirmed(reference_code));
    before.observed_bank_angle_rad = 0.1F;
    run(499);
    EXPECT_TRUE(confirmed(reference_code));
    run(1);
    EXPECT_FALSE(confirmed(reference_code));
    EXPECT_EQ(qualified.roll_angle_rad, 0.0F);
}

TEST_F(AnInputMonitor, JudgesTheReferenceByTheBankSensorWhereThereIsOne) {
    inputs.bank_angle_rad = 0.1F;
    before.observed_bank_angle_rad = 0.0F;
    inputs.roll_angle_rad = 0.1F;
    run(500);
    EXPECT_TRUE(confirmed(reference_code));
    memory = {};
    monitor.start(rsi_test_large_suv());
    inputs.bank_angle_rad = 0.5F;  // of no road
    before.observed_bank_angle_rad = 0.1F;
    inputs.roll_angle_rad = 0.0F;
    run(2000);
    EXPECT_FALSE(confirmed(reference_code));
}

// An accelerometer that shows half of the force.
class AnInputMonitorWithAWeakAccelerometer : public AnInputMonitor {
 protected:
    void turn_with_half(float force_mps2, int cycles) {
        turn_at(force_mps2);
        inputs.lateral_specific_force_mps2 = 0.5F * force_mps2;
        inputs.roll_angle_rad = monitoring_test::held_roll_angle_rad(suv, force_mps2);
        run(cycles);
    }

    rsi::Parameters suv = rsi_test_large_suv();
    static constexpr DiagnosticCode gain_code = DiagnosticCode::lateral_acceleration_gain;
};

TEST_F(AnInputMonitorWithAWeakAccelerometer, TakesItOutAfterTurnsToBothSides) {
    turn_with_half(2.0F, 300);
    EXPECT_FALSE(confirmed(gain_code));
    EXPECT_EQ(qualified.lateral_specific_force_mps2, 1.0F);
    turn_with_half(-2.0F, 300);
    EXPECT_TRUE(confirmed(gain_code));
    EXPECT_TRUE(std::isnan(qualified.lateral_specific_force_mps2));
    EXPECT_FALSE(confirmed(lateral_code));
    turn_with_half(0.0F, 800);  // on a straight it is as good as any
    EXPECT_TRUE(confirmed(gain_code));
    turn_with_half(0.0F, 200);  // and it is not known to be wrong
    EXPECT_FALSE(confirmed(gain_code));
}

TEST_F(AnInputMonitorWithAWeakAccelerometer, TakesItOutInTheFirstHardTurn) {
    turn_with_half(4.0F, 100);
    EXPECT_TRUE(confirmed(gain_code));
    EXPECT_TRUE(std::isnan(qualified.lateral_specific_force_mps2));
}

// A spin is no excuse: the body rolls as the force makes it.
TEST_F(AnInputMonitorWithAWeakAccelerometer, TakesItOutInASpinToo) {
    turn_with_half(6.0F, 1);
    inputs.yaw_rate_radps = 10.6F / inputs.speed_mps;
    run(100);
    EXPECT_TRUE(confirmed(gain_code));
}

TEST_F(AnInputMonitorWithAWeakAccelerometer, StillKnowsItAfterAStall) {
    turn_with_half(4.0F, 100);
    ASSERT_TRUE(confirmed(gain_code));
    monitor.start(suv);
    turn_with_half(0.0F, 500);
    EXPECT_TRUE(confirmed(gain_code));
}

TEST_F(AnInputMonitorWithAWeakAccelerometer, TakesItBackAfterRightTurns) {
    turn_with_half(4.0F, 100);
    ASSERT_TRUE(confirmed(gain_code));
    for (int cycle = 0; cycle < 300; ++cycle) {
        turn_with_half(4.0F, 0);
        inputs.lateral_specific_force_mps2 = 4.0F;
        run(1);
    }
    EXPECT_FALSE(confirmed(gain_code));
    EXPECT_EQ(qualified.lateral_specific_force_mps2, 4.0F);
}

TEST_F(AnInputMonitorWithAWeakAccelerometer, SetsNoCodeInAWarningNorByARollAngleThatIsNotUsed) {
    before.state = RSI_STATE_WARNING;
    turn_with_half(4.0F, 1000);
    EXPECT_FALSE(confirmed(gain_code));
    before.state = RSI_STATE_READY;
    before.roll_source = RSI_ROLL_OBSERVER;
    before.observed_roll_angle_rad = inputs.roll_angle_rad;
    run(1000);
    EXPECT_FALSE(confirmed(gain_code));
    before.roll_source = RSI_ROLL_SENSOR;
    inputs.roll_angle_rad = nan;
    run(1000);
    EXPECT_FALSE(confirmed(gain_code));
}

// At the end of a spin: the tyres hold a force that neither the slow wheels nor the body's roll explain.
TEST_F(AnInputMonitorWithAWeakAccelerometer, TakesNoVehicleThatSlidesSlowlyForOneThatTurns) {
    for (const float speed_mps : {4.9F, 5.1F}) {
        inputs.speed_mps = speed_mps;
        turn_with_half(1.2F, 100);
        inputs.lateral_specific_force_mps2 = 3.5F;
        run(100);
        EXPECT_EQ(confirmed(gain_code), speed_mps > 5.0F);
    }
}

// 18 km/h or less: an upright body shows no force.
class AnInputMonitorOfASlowVehicle : public AnInputMonitor {
 protected:
    AnInputMonitorOfASlowVehicle() { inputs.speed_mps = 2.0F; }
};

TEST_F(AnInputMonitorOfASlowVehicle, BlamesAnImpossibleLateralAccelerationAtOnce) {
    run(100);
    inputs.lateral_specific_force_mps2 = 8.6F;
    run(1);
    EXPECT_TRUE(confirmed(lateral_code));
    EXPECT_TRUE(std::isnan(qualified.lateral_specific_force_mps2));
    inputs.lateral_specific_force_mps2 = 0.0F;
    run(99);
    EXPECT_TRUE(confirmed(lateral_code));
    run(100);
    EXPECT_FALSE(confirmed(lateral_code));
    EXPECT_EQ(qualified.lateral_specific_force_mps2, 0.0F);
}

TEST_F(AnInputMonitorOfASlowVehicle, BlamesALateralAccelerationUnderWhichTheBodyDoesNotLean) {
    inputs.lateral_specific_force_mps2 = 4.0F;
    run(40);
    EXPECT_FALSE(confirmed(lateral_code));
    run(1);  // 4 m/s^2 with a lag of 0.3 s are 3 after 0.41 s
    EXPECT_TRUE(confirmed(lateral_code));
    EXPECT_FALSE(confirmed(roll_sensor_code));
}

TEST_F(AnInputMonitorOfASlowVehicle, BlamesItAndNotTheRollSensorWhenTheObserverContradicts) {
    inputs.lateral_specific_force_mps2 = 2.5F;
    run(100);
    before.roll_sensor_disagrees = 1;
    run(1);
    EXPECT_TRUE(confirmed(lateral_code));
    EXPECT_FALSE(confirmed(roll_sensor_code));
}

// 0.42 rad, and the body leans with it.
TEST_F(AnInputMonitorOfASlowVehicle, StandsOnTheSteepestRoad) {
    const rsi::Parameters suv = rsi_test_large_suv();
    inputs.lateral_specific_force_mps2 = 4.3F;
    inputs.roll_angle_rad = monitoring_test::held_roll_angle_rad(suv, 4.3F);
    run(1000);
    EXPECT_FALSE(confirmed(lateral_code));
    EXPECT_EQ(qualified.lateral_specific_force_mps2, 4.3F);
}

// If it cannot be judged, a good second has to come without a break.
TEST_F(AnInputMonitorOfASlowVehicle, DoesNotJudgeALateralAccelerationWithoutASpeed) {
    inputs.lateral_specific_force_mps2 = 6.0F;
    run(50);
    ASSERT_TRUE(confirmed(lateral_code));
    inputs.lateral_specific_force_mps2 = 0.0F;
    run(74);  // for the first 14 it is still beyond the others
    inputs.speed_mps = nan;
    run(500);
    EXPECT_TRUE(confirmed(lateral_code));
    inputs.speed_mps = 2.0F;
    run(4 + 39);  // the speed is used from its fifth good cycle on
    EXPECT_TRUE(confirmed(lateral_code));
    run(1);
    EXPECT_FALSE(confirmed(lateral_code));
}

// A ferry turns a vehicle that stands; the force of gravity shows it.
TEST_F(AnInputMonitorOfASlowVehicle, TakesADeckThatTurnsForNoFaultOfTheRollRate) {
    const rsi::Parameters suv = rsi_test_large_suv();
    for (const bool shown : {true, false}) {
        start_anew(suv);
        float bank_rad = 0.0F;
        for (int cycle = 0; cycle < 300; ++cycle) {
            const bool twists = cycle >= 100 && cycle < 200;
            bank_rad += (twists && shown) ? 0.0021F : 0.0F;
            const float noise = (cycle % 2 == 0) ? 0.001F : -0.001F;
            inputs.lateral_specific_force_mps2 = 9.80665F * std::sin(bank_rad) + noise;
            inputs.roll_angle_rad =
                monitoring_test::held_roll_angle_rad(suv, inputs.lateral_specific_force_mps2);
            inputs.roll_rate_radps = (twists ? 0.21F : 0.0F) + noise;
            run(1);
        }
        EXPECT_EQ(confirmed(DiagnosticCode::roll_rate_offset), !shown);
    }
}

class AnInputMonitorOfAnAttitudeSensor : public AnInputMonitor {
 protected:
    AnInputMonitorOfAnAttitudeSensor() {
        suv.roll_angle_reference = RSI_ROLL_AGAINST_HORIZON;
        monitor.start(suv);
    }

    rsi_parameters suv = rsi_test_large_suv();
};

TEST_F(AnInputMonitorOfAnAttitudeSensor, FindsTheBankInItAndMissesItWhereItIsNot) {
    before.observed_bank_angle_rad = 0.1F;
    inputs.roll_angle_rad = 0.1F;
    run(1000);
    EXPECT_FALSE(confirmed(reference_code));
    EXPECT_EQ(qualified.roll_angle_rad, 0.1F);
    inputs.roll_angle_rad = 0.0F;
    run(1000);
    EXPECT_TRUE(confirmed(reference_code));
    EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
}

TEST_F(AnInputMonitorOfAnAttitudeSensor, ComparesItWithTheObserverLessTheBank) {
    before.roll_source = RSI_ROLL_OBSERVER;
    inputs.roll_angle_rad = 0.1F;
    before.observed_roll_angle_rad = 0.02F;
    before.observed_bank_angle_rad = 0.08F;
    run(100);
    EXPECT_FALSE(confirmed(roll_sensor_code));
    inputs.bank_angle_rad = 0.0F;  // measured, and there is none
    run(1);
    EXPECT_TRUE(confirmed(roll_sensor_code));
    inputs.bank_angle_rad = 0.08F;
    run(99);
    EXPECT_TRUE(confirmed(roll_sensor_code));
    run(1);
    EXPECT_FALSE(confirmed(roll_sensor_code));
    inputs.bank_angle_rad = nan;
    before.observed_bank_angle_rad = nan;
    run(1000);
    EXPECT_FALSE(confirmed(roll_sensor_code));
}

// The angle of the suspension is a reference for the lateral force; one against the horizon only together
// with the bank that a sensor has measured.
TEST_F(AnInputMonitorOfAnAttitudeSensor, IsAReferenceOfATurnOnlyWithABankSensor) {
    turn_at(2.1F);
    inputs.lateral_specific_force_mps2 = -2.1F;
    inputs.roll_angle_rad = 0.03F;
    run(1000);
    EXPECT_FALSE(confirmed(lateral_code));
    EXPECT_FALSE(confirmed(yaw_code));
    inputs.bank_angle_rad = 0.0F;
    run(20);
    EXPECT_TRUE(confirmed(lateral_code));
    EXPECT_FALSE(confirmed(yaw_code));
}

// On a bank of 0.1 rad the body leans by 0.02 rad to the left, and by as much to the right.
TEST_F(AnInputMonitorOfAnAttitudeSensor, IsAReferenceOfATurnByItsExcessOverTheBank) {
    turn_at(2.1F);
    inputs.lateral_specific_force_mps2 = -2.1F;
    inputs.bank_angle_rad = 0.1F;
    inputs.roll_angle_rad = 0.08F;
    run(100);
    EXPECT_FALSE(confirmed(lateral_code));
    inputs.roll_angle_rad = 0.12F;
    run(20);
    EXPECT_TRUE(confirmed(lateral_code));
}

TEST_F(AnInputMonitorOfAnAttitudeSensor, JudgesTheVerticalAccelerationByTheObserversAngle) {
    turn_at(8.0F);
    inputs.roll_angle_rad = 0.15F;
    before.observed_roll_angle_rad = 0.0F;
    run(1000);  // 8 m/s^2 of 0.15 rad are 1.2
    EXPECT_FALSE(confirmed(DiagnosticCode::vertical_acceleration_offset));
    inputs.vertical_specific_force_mps2 = 9.80665F + 1.6F;
    run(1000);
    EXPECT_TRUE(confirmed(DiagnosticCode::vertical_acceleration_offset));
}

TEST_F(AnInputMonitorOfAnAttitudeSensor, BlamesTheAngleThatLeansIntoTheTurnOnlyWithABankSensor) {
    turn_at(3.0F);
    roll(40, -0.004F, 0.0F);
    EXPECT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_rate_radps));
    memory = {};
    monitor.start(suv);
    inputs.bank_angle_rad = 0.0F;
    roll(40, -0.004F, 0.0F);
    EXPECT_TRUE(confirmed(roll_code));
    EXPECT_TRUE(std::isnan(qualified.roll_angle_rad));
}

}  // namespace
}  // namespace monitoring_input_monitor_test
