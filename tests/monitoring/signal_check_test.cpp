// Each signal by itself, at the limits that docs/safety.md states: range, jump, noise, and the
// references by which it counts as stuck; the value used in its place meanwhile; what a failing signal is
// not asked about.
#include "rsi/ecu/monitoring/signal_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "rsi/ecu/monitoring/input_monitor.hpp"
#include "tests/support/large_suv.h"

namespace monitoring_signal_check_test {
namespace {

using rsi::monitoring::DiagnosticCode;
using rsi::monitoring::EventStatus;
using rsi::monitoring::FreshFrames;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

using Member = float rsi::Inputs::*;

// Straight on at 30 m/s, every frame fresh, the component content.
class ASignalOfTheInputMonitor : public ::testing::Test {
 protected:
    ASignalOfTheInputMonitor() { start(); }

    void start() {
        monitor.start(vehicle);
        memory = {};
        inputs = {};
        inputs.vertical_specific_force_mps2 = 10.0F;
        inputs.bank_angle_rad = nan;
        inputs.speed_mps = 30.0F;
        before.state = RSI_STATE_READY;
        before.roll_source = RSI_ROLL_SENSOR;
    }

    void run(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            qualified = monitor.qualify(inputs, fresh, before, memory);
        }
    }

    void run_without(FreshFrames frames, int cycles) {
        fresh = frames;
        run(cycles);
        fresh = all;
    }

    EventStatus status(DiagnosticCode code) const { return memory.status(code); }

    static constexpr FreshFrames all{true, true, true};

    rsi::Parameters vehicle{rsi_test_large_suv()};
    rsi::monitoring::InputMonitor monitor;
    rsi::monitoring::DiagnosticMemory memory;
    rsi::Inputs inputs{};
    rsi::Inputs qualified{};
    rsi::Outputs before{};
    FreshFrames fresh{all};
};

struct StatedLimits {
    const char* name;
    Member signal;
    float minimum;
    float maximum;
    float jump;
    float shake;
    DiagnosticCode invalid;
    DiagnosticCode jumps;
    FreshFrames without_its_frame;
};

void PrintTo(const StatedLimits& limits, std::ostream* out) {
    *out << limits.name;
}

constexpr FreshFrames without_imu{false, true, true};
constexpr FreshFrames without_roll_angle{true, false, true};
constexpr FreshFrames without_vehicle_motion{true, true, false};

constexpr StatedLimits stated_limits[] = {
    {"LateralAcceleration", &rsi::Inputs::lateral_specific_force_mps2, -40.0F, 40.0F, 12.0F, 3.0F,
     DiagnosticCode::lateral_acceleration_invalid, DiagnosticCode::lateral_acceleration_jump, without_imu},
    {"VerticalAcceleration", &rsi::Inputs::vertical_specific_force_mps2, -40.0F, 55.0F, 12.0F, 2.2F,
     DiagnosticCode::vertical_acceleration_invalid, DiagnosticCode::vertical_acceleration_jump, without_imu},
    {"RollRate", &rsi::Inputs::roll_rate_radps, -5.22F, 5.22F, 0.5F, 0.1F, DiagnosticCode::roll_rate_invalid,
     DiagnosticCode::roll_rate_jump, without_imu},
    {"RollAngle", &rsi::Inputs::roll_angle_rad, -1.9F, 1.9F, 0.044F, 0.04F,
     DiagnosticCode::roll_angle_invalid, DiagnosticCode::roll_angle_jump, without_roll_angle},
    {"YawRate", &rsi::Inputs::yaw_rate_radps, -4.0F, 4.0F, 0.2F, 0.1F, DiagnosticCode::yaw_rate_invalid,
     DiagnosticCode::yaw_rate_jump, without_vehicle_motion},
    {"Speed", &rsi::Inputs::speed_mps, 0.0F, 97.0F, 1.5F, 0.5F, DiagnosticCode::speed_invalid,
     DiagnosticCode::speed_jump, without_vehicle_motion},
    {"SteeringWheelAngle", &rsi::Inputs::steering_wheel_angle_rad, -15.0F, 15.0F, 2.0F, 0.3F,
     DiagnosticCode::steering_invalid, DiagnosticCode::steering_jump, without_vehicle_motion},
};

class ASignal : public ASignalOfTheInputMonitor, public ::testing::WithParamInterface<StatedLimits> {
 protected:
    const StatedLimits& limits{GetParam()};
    const float usual{inputs.*limits.signal};

    float sent() const { return inputs.*limits.signal; }
    float used() const { return qualified.*limits.signal; }
    void send(float value, int cycles = 1) {
        inputs.*limits.signal = value;
        run(cycles);
    }
    // White noise has no shorter period than this.
    void send_alternating(float by, int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            up = !up;
            send(usual + (up ? by : -by));
        }
        inputs.*limits.signal = usual;
    }

    bool up{false};
};

// A value that is no number says nothing of jumps; one that is bridged, nothing at all.
TEST_P(ASignal, IsTestedByEachValueThatCanBeJudged) {
    const auto is_tested = [&](float value) {
        memory.begin_cycle({});
        send(value);
        const rsi::monitoring::CodeSet both = rsi::monitoring::set_of(limits.invalid, limits.jumps);
        const rsi::monitoring::CodeSet tested = memory.tested_codes() & both;
        EXPECT_TRUE(tested == both || tested == 0U);
        return tested != 0U;
    };
    EXPECT_TRUE(is_tested(usual));
    EXPECT_FALSE(is_tested(nan));
    EXPECT_FALSE(is_tested(limits.maximum + 1.0F));
    start();
    run(1);
    EXPECT_TRUE(is_tested(usual + 2.0F * limits.jump)) << "and found wanting";
    start();
    run(1);
    memory.begin_cycle({});
    run_without(limits.without_its_frame, 1);
    EXPECT_EQ(memory.tested_codes() & rsi::monitoring::set_of(limits.invalid, limits.jumps), 0U);
}

TEST_P(ASignal, IsValidUpToItsLimitsAndNotBeyond) {
    for (const float limit : {limits.minimum, limits.maximum}) {
        const float outward = (limit == limits.minimum) ? -infinity : infinity;
        start();
        send(limit);
        EXPECT_EQ(status(limits.invalid), EventStatus::none) << limit;
        send(std::nextafter(limit, outward));
        EXPECT_EQ(status(limits.invalid), EventStatus::set) << limit;
    }
    for (const float none : {nan, infinity, -infinity}) {
        start();
        send(none);
        EXPECT_EQ(status(limits.invalid), EventStatus::set);
    }
}

TEST_P(ASignal, JumpsWhenItChangesByMoreThanItsLimitInOneCycle) {
    for (const float sign : {1.0F, -1.0F}) {
        start();
        run(5);
        send(usual + sign * limits.jump);
        EXPECT_EQ(status(limits.jumps), EventStatus::none);
        send(usual + sign * limits.jump * 2.001F);
        EXPECT_EQ(status(limits.jumps), EventStatus::set);
    }
}

TEST_P(ASignal, IsComparedWithTheLastGoodValueNotWithTheJump) {
    run(5);
    send(usual + 1.1F * limits.jump);
    ASSERT_EQ(status(limits.jumps), EventStatus::set);
    send(usual + 1.1F * limits.jump);  // as far from the last good one, if not from the one before
    send(usual + 1.1F * limits.jump);
    EXPECT_EQ(status(limits.jumps), EventStatus::confirmed);
}

TEST_P(ASignal, IsShakenWhenTheChangeOfItsChangeExceedsItsLimit) {
    send_alternating(0.249F * limits.shake, 300);  // the second difference is four times as large
    EXPECT_EQ(status(limits.jumps), EventStatus::none);
    EXPECT_EQ(used(), usual + (up ? 0.249F : -0.249F) * limits.shake);
    send_alternating(0.251F * limits.shake, 100);
    EXPECT_EQ(status(limits.jumps), EventStatus::confirmed);
    EXPECT_TRUE(std::isnan(used()));
}

// With a lag of 0.1 s twice the limit is half of the way after 0.07 s; the first two values have no second
// difference.
TEST_P(ASignal, IsShakenByTheMeanOver100Milliseconds) {
    send_alternating(0.49F * limits.shake, 8);
    EXPECT_EQ(status(limits.jumps), EventStatus::none);
    send_alternating(0.49F * limits.shake, 1);
    EXPECT_EQ(status(limits.jumps), EventStatus::set);
}

TEST_P(ASignal, IsBridgedByItsLastGoodValueForTwoCyclesThenInvalidated) {
    run(5);
    const float beyond = 1.01F * limits.maximum;
    for (int cycle = 0; cycle < 2; ++cycle) {
        send(beyond);
        EXPECT_EQ(used(), usual) << cycle;
    }
    send(beyond);
    EXPECT_EQ(status(limits.invalid), EventStatus::confirmed);
    EXPECT_TRUE(std::isnan(used()));
}

TEST_P(ASignal, ThatSaysNothingIsNotBridged) {
    run(5);
    send(nan);
    EXPECT_TRUE(std::isnan(used()));
    send(usual);
    EXPECT_EQ(used(), usual);
}

TEST_P(ASignal, ThatWasOutOfItsRangeComesBackAfterFiveGoodCycles) {
    run(5);
    send(nan, 10);
    ASSERT_EQ(status(limits.invalid), EventStatus::confirmed);
    send(usual, 4);
    EXPECT_TRUE(std::isnan(used()));
    send(usual);
    EXPECT_EQ(status(limits.invalid), EventStatus::healed);
    EXPECT_EQ(used(), usual);
    EXPECT_EQ(status(limits.jumps), EventStatus::none);
}

// Smooth again is good again, wherever it is now.
TEST_P(ASignal, ThatHasJumpedComesBackAfterHalfASecondFromWhereItIs) {
    const float elsewhere = usual + 1.5F * limits.jump;
    run(5);
    send(elsewhere, 3);
    ASSERT_EQ(status(limits.jumps), EventStatus::confirmed);
    EXPECT_TRUE(std::isnan(used()));
    send(elsewhere, 49);
    EXPECT_TRUE(std::isnan(used()));
    send(elsewhere, 10);  // until the mean of its changes has calmed down too
    EXPECT_EQ(status(limits.jumps), EventStatus::healed);
}

TEST_P(ASignal, MayBeAnywhereAfterACycleWithoutItsFrame) {
    run(5);
    run_without(limits.without_its_frame, 1);
    send(usual + 1.5F * limits.jump);
    EXPECT_EQ(status(limits.jumps), EventStatus::none);
    EXPECT_EQ(used(), sent());
}

TEST_P(ASignal, MayBeAnywhereAfterACycleInWhichItSaidNothing) {
    run(5);
    send(nan);
    send(usual + 1.5F * limits.jump);
    EXPECT_EQ(status(limits.jumps), EventStatus::none);
    EXPECT_EQ(used(), sent());
}

TEST_P(ASignal, IsNotBridgedByAValueOfBeforeAGap) {
    run(5);
    run_without(limits.without_its_frame, 1);
    send(1.01F * limits.maximum);
    EXPECT_TRUE(std::isnan(used()));
}

TEST_P(ASignal, IsNotJudgedWithoutItsFrame) {
    run(5);
    inputs.*limits.signal = nan;
    run_without(limits.without_its_frame, 10);
    EXPECT_EQ(status(limits.invalid), EventStatus::none);
    EXPECT_TRUE(std::isnan(used()));
}

// Without the frame that carries it the noise of before says nothing either.
TEST_P(ASignal, ForgetsItsNoiseInACycleWithoutItsFrame) {
    send_alternating(0.249F * limits.shake, 100);
    run_without(limits.without_its_frame, 1);
    send_alternating(0.49F * limits.shake, 8);
    EXPECT_EQ(status(limits.jumps), EventStatus::none);
}

// Accelerometers without a filter. The second difference of white noise of 1 m/s^2 is one of 2.45 m/s^2.
TEST_P(ASignal, IsAdmittedTheNoiseThatIsCalibrated) {
    vehicle.accelerometer_noise_mps2 = 1.0F;
    const bool accelerometer = limits.maximum >= 40.0F && limits.jump == 12.0F;
    const float admitted = accelerometer ? 2.45F : 0.0F;
    start();
    run(5);
    send(usual + 0.999F * (limits.jump + admitted));
    EXPECT_EQ(status(limits.jumps), EventStatus::none);
    start();
    run(5);
    send(usual + 1.001F * (limits.jump + admitted));
    EXPECT_EQ(status(limits.jumps), EventStatus::set);
    start();
    send_alternating(0.249F * (limits.shake + admitted), 300);
    EXPECT_EQ(status(limits.jumps), EventStatus::none);
    send_alternating(0.251F * (limits.shake + admitted), 100);
    EXPECT_EQ(status(limits.jumps), EventStatus::confirmed);
}

INSTANTIATE_TEST_SUITE_P(OfEachSensor, ASignal, ::testing::ValuesIn(stated_limits),
                         [](const auto& tested) { return std::string{tested.param.name}; });

// The check of one signal alone: from -10 to 10, by 2 in a cycle.
class ASignalCheck : public ::testing::Test {
 protected:
    float qualify(float value, int times = 1) {
        float answer = nan;
        for (int cycle = 0; cycle < times; ++cycle) {
            answer = check.qualify(value, memory);
        }
        return answer;
    }

    rsi::monitoring::SignalCheck check{
        {-10.0F, 10.0F, 2.0F, 1.0F, DiagnosticCode::speed_invalid, DiagnosticCode::speed_jump}};
    rsi::monitoring::DiagnosticMemory memory;
};

TEST_F(ASignalCheck, KnowsNothingBeforeItsFirstGoodValue) {
    EXPECT_TRUE(std::isnan(qualify(11.0F)));
    EXPECT_EQ(qualify(9.0F), 9.0F);
    EXPECT_EQ(qualify(11.0F), 9.0F);
}

TEST_F(ASignalCheck, TakesUpTheSignalWhereItIsOnceItsJumpHasHealed) {
    qualify(0.0F, 5);
    EXPECT_EQ(qualify(5.0F, 2), 0.0F);
    EXPECT_TRUE(std::isnan(qualify(5.0F)));
    EXPECT_TRUE(std::isnan(qualify(5.0F, 49)));
    EXPECT_EQ(qualify(5.0F), 5.0F);
    EXPECT_EQ(qualify(7.1F), 5.0F);  // is compared with that from now on
}

// A value beyond its range is no base for a comparison.
TEST_F(ASignalCheck, DoesNotCallTheReturnIntoTheRangeAJump) {
    qualify(0.0F, 5);
    qualify(40.0F, 100);
    ASSERT_TRUE(memory.confirmed(DiagnosticCode::speed_invalid));
    ASSERT_EQ(memory.status(DiagnosticCode::speed_jump), EventStatus::none);  // nor is it judged there
    check.forget();
    EXPECT_TRUE(std::isnan(qualify(1.0F, 4)));
    EXPECT_EQ(qualify(1.0F), 1.0F);
    EXPECT_EQ(memory.status(DiagnosticCode::speed_jump), EventStatus::none);
}

TEST_F(ASignalCheck, HasNoJumpInTheFirstValueInsideTheRangeAgain) {
    qualify(9.0F, 5);
    qualify(11.0F, 30);  // slightly beyond: the return is too small a step to shake it
    ASSERT_TRUE(memory.confirmed(DiagnosticCode::speed_invalid));
    qualify(8.5F);
    EXPECT_EQ(memory.status(DiagnosticCode::speed_jump), EventStatus::none);
}

TEST_F(ASignalCheck, NeedsThreeValuesForTheChangeOfAChange) {
    check = rsi::monitoring::SignalCheck{
        {-10.0F, 10.0F, 100.0F, 1.0F, DiagnosticCode::speed_invalid, DiagnosticCode::speed_jump}};
    EXPECT_EQ(qualify(10.0F), 10.0F);  // for any content of its memory
    EXPECT_EQ(qualify(-10.0F), -10.0F);
    EXPECT_EQ(qualify(10.0F), 10.0F);  // 0.35 of the change of the change
    EXPECT_EQ(qualify(-10.0F), -10.0F);
    EXPECT_EQ(qualify(10.0F), 10.0F);
    EXPECT_EQ(qualify(-10.0F), 10.0F);  // shaken
    EXPECT_EQ(memory.status(DiagnosticCode::speed_jump), EventStatus::set);
}

TEST_F(ASignalCheck, BridgesASingleValueThatIsOffHoweverFar) {
    for (const float next : {1.3F, 1.6F}) {
        memory = {};
        check = rsi::monitoring::SignalCheck{
            {-10.0F, 10.0F, 100.0F, 1.0F, DiagnosticCode::speed_invalid, DiagnosticCode::speed_jump}};
        for (const float value : {0.0F, 0.0F, 9.0F, 0.0F, 0.0F}) {
            EXPECT_EQ(qualify(value), value);
        }
        EXPECT_EQ(qualify(next), next < 1.5F ? next : 0.0F);  // one more change of so much
    }
}

// Steps of more than 5 in a cycle, as of the accelerations.
class AStep : public ::testing::Test {
 protected:
    float qualify(float value, int times = 1, bool calm = true) {
        float answer = nan;
        for (int cycle = 0; cycle < times; ++cycle) {
            answer = check.qualify(value, memory, {0.0F, 0.0F, calm});
        }
        return answer;
    }
    EventStatus status() const { return memory.status(DiagnosticCode::speed_jump); }
    void burst(int cycles, float value = 8.0F) {
        qualify(value, cycles);
        qualify(0.0F);
    }

    rsi::monitoring::SignalCheck check{{-40.0F, 40.0F, 12.0F, 100.0F, DiagnosticCode::speed_invalid,
                                        DiagnosticCode::speed_jump, 5.0F, 5.0F}};
    rsi::monitoring::DiagnosticMemory memory;
};

TEST_F(AStep, OfACalmVehicleIsUsedAfter150Milliseconds) {
    qualify(0.0F, 5);
    EXPECT_EQ(qualify(5.0F), 5.0F);
    EXPECT_EQ(qualify(0.0F), 0.0F);
    for (int cycle = 0; cycle < 15; ++cycle) {
        EXPECT_EQ(qualify(5.1F), 0.0F) << cycle;
    }
    EXPECT_EQ(qualify(5.1F), 5.1F);
    EXPECT_EQ(qualify(5.2F), 5.2F);
    EXPECT_EQ(status(), EventStatus::none);
}

TEST_F(AStep, OfAVehicleThatMovesIsUsedAtOnce) {
    for (const float step : {8.0F, -8.0F}) {
        check.forget();
        qualify(0.0F, 5);
        EXPECT_EQ(qualify(step, 3), 0.0F);
        EXPECT_EQ(qualify(step, 1, false), step);
        EXPECT_EQ(check.last_good(), step);
    }
}

TEST_F(AStep, ThatComesBackWhileTheVehicleMovesIsNoBurst) {
    qualify(0.0F, 5);
    for (int number = 1; number <= 5; ++number) {
        EXPECT_EQ(qualify(8.0F, 10), 0.0F);
        EXPECT_EQ(qualify(0.0F, 10, false), 0.0F);
    }
    EXPECT_EQ(status(), EventStatus::none);
}

TEST_F(AStep, ThatComesBackIsABurstAndTheThirdOneConfirmsTheCode) {
    qualify(0.0F, 5);
    for (int number = 1; number <= 2; ++number) {
        burst(10);
        EXPECT_EQ(status(), EventStatus::none) << number;
        EXPECT_EQ(qualify(0.0F, 2000), 0.0F);
    }
    EXPECT_EQ(qualify(8.0F, 10), 0.0F);
    EXPECT_TRUE(std::isnan(qualify(0.0F)));
    EXPECT_EQ(status(), EventStatus::confirmed);
    EXPECT_TRUE(std::isnan(qualify(0.0F, 49)));
    EXPECT_EQ(qualify(0.0F), 0.0F);
    EXPECT_EQ(status(), EventStatus::healed);
    burst(2);
    EXPECT_EQ(status(), EventStatus::confirmed);  // the next one is known at once
}

TEST_F(AStep, AMinuteAfterTheLastBurstIsTheFirstOneAgain) {
    for (const int samples : {5999, 6000}) {  // from the end of one burst to that of the next
        check.forget();
        memory = {};
        qualify(0.0F, 10000);
        for (int number = 1; number <= 3; ++number) {
            qualify(0.0F, samples - 11);
            burst(10);
        }
        EXPECT_EQ(status(), samples < 6000 ? EventStatus::confirmed : EventStatus::none);
    }
}

TEST_F(AStep, ThatStaysIsNoBurst) {
    qualify(0.0F, 5);
    for (int number = 0; number < 10; ++number) {
        qualify(8.0F, 100);
        qualify(0.0F, 100);
    }
    EXPECT_EQ(status(), EventStatus::none);
}

TEST_F(AStep, BeyondRangeOrJumpIsABurstTooIfItIsTooShortForTheCode) {
    for (const float value : {41.0F, 20.0F}) {
        qualify(0.0F, 7000);  // longer than bursts are remembered
        memory = {};
        for (int number = 1; number <= 3; ++number) {
            EXPECT_EQ(memory.next().occurrences, 0U) << number;
            burst(2, value);
            qualify(0.0F, 100);
        }
        EXPECT_EQ(status(), EventStatus::healed) << value;
    }
}

TEST_F(AStep, IsDoubtedDownwardsOnlyWhereUpwardsHasNoLimit) {
    check = rsi::monitoring::SignalCheck{{-40.0F, 40.0F, 12.0F, 100.0F, DiagnosticCode::speed_invalid,
                                          DiagnosticCode::speed_jump, 1.0e6F, 5.0F}};
    qualify(0.0F, 5);
    EXPECT_EQ(qualify(8.0F), 8.0F);
    EXPECT_EQ(qualify(0.0F), 8.0F);
    EXPECT_EQ(qualify(8.0F), 8.0F);
}

// A code that has not healed yet keeps the signal from use, whatever step it makes.
TEST_F(AStep, OfASignalWithItsCodeIsNotUsed) {
    qualify(0.0F, 5);
    qualify(20.0F, 3);
    ASSERT_EQ(status(), EventStatus::confirmed);
    EXPECT_TRUE(std::isnan(qualify(12.0F)));
}

TEST_F(AStep, IsForgottenWithALostFrame) {
    qualify(0.0F, 5);
    for (int number = 1; number <= 5; ++number) {
        qualify(8.0F, 10);
        check.forget();
        EXPECT_EQ(qualify(0.0F, 10), 0.0F);
    }
    EXPECT_EQ(status(), EventStatus::none);
}

TEST_F(ASignalOfTheInputMonitor, RollAngleJumpsByMoreOrLessThanTheRollRateSays) {
    constexpr float turned_rad = 0.02F;  // in a cycle, at 2 rad/s
    for (const float sign : {1.0F, -1.0F}) {
        start();
        inputs.roll_rate_radps = 2.0F;
        run(5);
        for (const float more_rad : {0.0435F, 0.0445F}) {
            inputs.roll_angle_rad += turned_rad + sign * more_rad;
            run(1);
            EXPECT_EQ(status(DiagnosticCode::roll_angle_jump),
                      more_rad < 0.044F ? EventStatus::none : EventStatus::set);
        }
    }
}

TEST_F(ASignalOfTheInputMonitor, RollAngleIsTakenToStandWithoutARollRate) {
    inputs.roll_rate_radps = nan;
    run(5);
    inputs.roll_angle_rad = 0.0435F;
    run(1);
    EXPECT_EQ(status(DiagnosticCode::roll_angle_jump), EventStatus::none);
    inputs.roll_angle_rad += 0.0445F;
    run(1);
    EXPECT_EQ(status(DiagnosticCode::roll_angle_jump), EventStatus::set);
}

TEST_F(ASignalOfTheInputMonitor, BankAngleIsThatOfARoadUpTo45Percent) {
    for (const float sign : {1.0F, -1.0F}) {
        start();
        inputs.bank_angle_rad = sign * 0.42F;
        run(10);
        EXPECT_EQ(status(DiagnosticCode::bank_angle_invalid), EventStatus::none);
        EXPECT_EQ(qualified.bank_angle_rad, inputs.bank_angle_rad);
        inputs.bank_angle_rad = sign * 0.4201F;
        run(2);
        EXPECT_EQ(status(DiagnosticCode::bank_angle_invalid), EventStatus::set);
        run(1);
        EXPECT_EQ(status(DiagnosticCode::bank_angle_invalid), EventStatus::confirmed);
        EXPECT_TRUE(std::isnan(qualified.bank_angle_rad));
    }
}

TEST_F(ASignalOfTheInputMonitor, BankAngleIsNoFaultWhenItIsNotThere) {
    run(10);
    EXPECT_EQ(status(DiagnosticCode::bank_angle_invalid), EventStatus::none);
    inputs.bank_angle_rad = 1.0F;
    run_without(without_roll_angle, 10);  // nor judged without its frame
    EXPECT_EQ(status(DiagnosticCode::bank_angle_invalid), EventStatus::none);
}

// A signal that stands while its reference moves by a span; its substitute.
struct StatedReference {
    const char* name;
    DiagnosticCode code;
    Member signal;
    Member reference;
    float moved;  // by which the reference has just not moved enough
    int cycles;   // over which it moves so, and stays there
};

void PrintTo(const StatedReference& stuck, std::ostream* out) {
    *out << stuck.name;
}

class AStuckSignal : public ASignalOfTheInputMonitor, public ::testing::WithParamInterface<StatedReference> {
 protected:
    // The first of equal values, then a number of them; the reference moves in the first ones.
    void repeat(int times, float share_of_limit) {
        const StatedReference& stuck = GetParam();
        start();
        move(6);  // only a speed that has shown its noise can be seen to stand still
        const float usual = inputs.*stuck.reference;
        inputs.*stuck.reference = usual + share_of_limit * stuck.moved;
        for (int cycle = 1; cycle <= times; ++cycle) {
            run(1);
            if (cycle == stuck.cycles) {
                inputs.*stuck.reference = usual;
            }
        }
    }
    void move(int times) {
        for (int cycle = 0; cycle < times; ++cycle) {
            inputs.*GetParam().signal += cycle % 2 == 0 ? 0.001F : -0.001F;
            run(1);
        }
    }
};

TEST_P(AStuckSignal, IsFoundAtThe21stEqualValueIfItsReferenceHasMovedEnough) {
    const StatedReference& stuck = GetParam();
    for (const float sign : {1.0F, -1.0F}) {
        repeat(100, sign * 0.99F);
        EXPECT_EQ(status(stuck.code), EventStatus::none);
        EXPECT_FALSE(std::isnan(qualified.*stuck.signal));
        repeat(19, sign * 1.01F);
        EXPECT_EQ(status(stuck.code), EventStatus::none);
        repeat(20, sign * 1.01F);
        EXPECT_EQ(status(stuck.code), EventStatus::confirmed);
        EXPECT_TRUE(std::isnan(qualified.*stuck.signal));
    }
}

TEST_P(AStuckSignal, ComesBackWhenItHasMoved20Times) {
    const StatedReference& stuck = GetParam();
    repeat(20, 1.01F);
    ASSERT_EQ(status(stuck.code), EventStatus::confirmed);
    move(19);
    EXPECT_EQ(status(stuck.code), EventStatus::confirmed);
    run(50);  // repetitions clear nothing
    EXPECT_EQ(status(stuck.code), EventStatus::confirmed);
    move(1);
    EXPECT_EQ(status(stuck.code), EventStatus::healed);
    EXPECT_FALSE(std::isnan(qualified.*stuck.signal));
}

TEST_P(AStuckSignal, IsNotClearedByAMissingReference) {
    const StatedReference& stuck = GetParam();
    repeat(20, 1.01F);
    ASSERT_EQ(status(stuck.code), EventStatus::confirmed);
    inputs.*stuck.reference = nan;
    run(500);
    EXPECT_EQ(status(stuck.code), EventStatus::confirmed);
    inputs.*stuck.reference = 0.0F;
    run(500);
    EXPECT_EQ(status(stuck.code), EventStatus::confirmed);
}

TEST_P(AStuckSignal, IsNotClearedByValuesThatAreNone) {
    const StatedReference& stuck = GetParam();
    repeat(20, 1.01F);
    ASSERT_EQ(status(stuck.code), EventStatus::confirmed);
    const float value = inputs.*stuck.signal;
    for (int time = 0; time < 50; ++time) {
        inputs.*stuck.signal = nan;
        run(1);
        inputs.*stuck.signal = value;
        run(10);
    }
    EXPECT_EQ(status(stuck.code), EventStatus::confirmed);
}

TEST_P(AStuckSignal, IsNotClearedByAStart) {
    const StatedReference& stuck = GetParam();
    repeat(20, 1.01F);
    ASSERT_EQ(status(stuck.code), EventStatus::confirmed);
    monitor.start(rsi_test_large_suv());
    run(500);
    EXPECT_EQ(status(stuck.code), EventStatus::confirmed);
}

INSTANTIATE_TEST_SUITE_P(
    OfEachSensor, AStuckSignal,
    ::testing::Values(StatedReference{"LateralAcceleration", DiagnosticCode::lateral_acceleration_stuck,
                                      &rsi::Inputs::lateral_specific_force_mps2, &rsi::Inputs::yaw_rate_radps,
                                      1.0F / 30.0F, 1},
                      StatedReference{"VerticalAcceleration", DiagnosticCode::vertical_acceleration_stuck,
                                      &rsi::Inputs::vertical_specific_force_mps2,
                                      &rsi::Inputs::lateral_specific_force_mps2, 1.5F, 1},
                      StatedReference{"RollRate", DiagnosticCode::roll_rate_stuck,
                                      &rsi::Inputs::roll_rate_radps, &rsi::Inputs::roll_angle_rad, 0.02F, 1},
                      StatedReference{"RollAngle", DiagnosticCode::roll_angle_stuck,
                                      &rsi::Inputs::roll_angle_rad, &rsi::Inputs::roll_rate_radps, 0.15F,
                                      10},  // 0.015 rad in ten cycles
                      StatedReference{"YawRate", DiagnosticCode::yaw_rate_stuck, &rsi::Inputs::yaw_rate_radps,
                                      &rsi::Inputs::lateral_specific_force_mps2, 1.5F, 1},
                      StatedReference{"Speed", DiagnosticCode::speed_stuck, &rsi::Inputs::speed_mps,
                                      &rsi::Inputs::yaw_rate_radps, 4.5F / 30.0F, 1}),
    [](const auto& tested) { return std::string{tested.param.name}; });

// A speed in large steps stays the same through any turn.
TEST_F(ASignalOfTheInputMonitor, SpeedIsNotStuckInStepsOfMoreThan5CentimetresPerSecond) {
    for (const float step_mps : {0.05F, std::nextafter(0.05F, 1.0F)}) {
        vehicle.speed_resolution_mps = step_mps;
        start();
        for (int cycle = 0; cycle < 6; ++cycle) {  // noise
            inputs.speed_mps += (cycle % 2 == 0) ? 0.001F : -0.001F;
            run(1);
        }
        for (int turn = 0; turn < 10; ++turn) {
            inputs.yaw_rate_radps = (turn % 2 == 0) ? 0.2F : -0.2F;
            run(20);
        }
        EXPECT_EQ(status(DiagnosticCode::speed_stuck),
                  step_mps > 0.05F ? EventStatus::none : EventStatus::confirmed);
    }
}

}  // namespace
}  // namespace monitoring_signal_check_test
