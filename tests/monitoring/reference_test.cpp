// A signal that fails by itself says nothing of the others: as long as it does, only its own codes are set.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "rsi/ecu/monitoring/input_monitor.hpp"
#include "tests/support/large_suv.h"

namespace monitoring_reference_test {
namespace {

using rsi::monitoring::DiagnosticCode;
using rsi::monitoring::EventStatus;

// A steady turn to the left of 9 m/s^2 at 30 m/s, seen by ideal sensors, which do repeat themselves.
class ASteadyTurn : public ::testing::Test {
 protected:
    ASteadyTurn() {
        monitor.start(rsi_test_large_suv());
        turn_at(9.0F);
        inputs.roll_angle_rad = 0.12F;
        inputs.vertical_specific_force_mps2 = 9.80665F - 9.0F * 0.12F;
        inputs.bank_angle_rad = 0.0F;
        inputs.vehicle_mass_kg = rsi::not_available;
        inputs.steering_wheel_angle_rad = 1.0F;
        before.state = RSI_STATE_READY;
        before.roll_source = RSI_ROLL_SENSOR;
        before.observed_roll_angle_rad = inputs.roll_angle_rad;
        run(10);
    }

    void turn_at(float lateral_mps2) {
        inputs.speed_mps = 30.0F;
        inputs.lateral_specific_force_mps2 = lateral_mps2;
        inputs.yaw_rate_radps = lateral_mps2 / inputs.speed_mps;
    }

    void run(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            qualified = monitor.qualify(inputs, {true, true, true}, before, memory);
        }
    }

    void expect_no_code_but(DiagnosticCode own) const {
        for (std::size_t index = 1U; index < rsi::monitoring::diagnostic_code_count; ++index) {
            const auto code = static_cast<DiagnosticCode>(index);
            EXPECT_EQ(memory.status(code), code == own ? EventStatus::confirmed : EventStatus::none)
                << "code " << index;
        }
    }

    rsi::monitoring::InputMonitor monitor;
    rsi::monitoring::DiagnosticMemory memory;
    rsi::Inputs inputs{};
    rsi::Inputs qualified{};
    rsi::Outputs before{};
};

TEST_F(ASteadyTurn, SetsNoCode) {
    run(1000);
    EXPECT_EQ(memory.next().code, DiagnosticCode::none);
}

struct Failing {
    const char* name;
    float rsi::Inputs::* signal;
    float beyond_range;
    float beyond_jump;
    DiagnosticCode invalid;
    DiagnosticCode jump;
};

void PrintTo(const Failing& failing, std::ostream* out) {
    *out << failing.name;
}

class AFailingSignal : public ASteadyTurn, public ::testing::WithParamInterface<Failing> {
 protected:
    const Failing& failing{GetParam()};
    float& signal{inputs.*failing.signal};
    const float usual{signal};
};

TEST_P(AFailingSignal, ThatIsOutOfRangeSetsNoOtherCode) {
    for (int cycle = 0; cycle < 1000; ++cycle) {
        signal = failing.beyond_range + 0.001F * static_cast<float>(cycle % 3);
        run(1);
    }
    expect_no_code_but(failing.invalid);
}

TEST_P(AFailingSignal, ThatJumpsSetsNoOtherCode) {
    for (int cycle = 0; cycle < 1000; ++cycle) {
        signal = usual + failing.beyond_jump * static_cast<float>((cycle + 1) % 3);
        run(1);
    }
    expect_no_code_but(failing.jump);
}

// From the first cycle in which it is seen. The third burst sets its own code; not that of an acceleration,
// whose steps may be true in a turn as hard as this.
TEST_P(AFailingSignal, ThatFailsNowAndThenSetsNoOtherCode) {
    for (int cycle = 0; cycle < 1000; ++cycle) {
        signal = (cycle % 4 == 1) ? failing.beyond_range : usual;
        run(1);
        ASSERT_FALSE(memory.confirmed(failing.invalid));
    }
    for (std::size_t index = 1U; index < rsi::monitoring::diagnostic_code_count; ++index) {
        const auto code = static_cast<DiagnosticCode>(index);
        const bool acceleration = failing.beyond_jump > 10.0F;
        EXPECT_EQ(memory.confirmed(code), !acceleration && (code == failing.jump)) << "code " << index;
    }
}

INSTANTIATE_TEST_SUITE_P(
    OfEachSensor, AFailingSignal,
    ::testing::Values(Failing{"LateralAcceleration", &rsi::Inputs::lateral_specific_force_mps2, -41.0F, 13.0F,
                              DiagnosticCode::lateral_acceleration_invalid,
                              DiagnosticCode::lateral_acceleration_jump},
                      Failing{"VerticalAcceleration", &rsi::Inputs::vertical_specific_force_mps2, -41.0F,
                              13.0F, DiagnosticCode::vertical_acceleration_invalid,
                              DiagnosticCode::vertical_acceleration_jump},
                      Failing{"RollRate", &rsi::Inputs::roll_rate_radps, -5.3F, 0.6F,
                              DiagnosticCode::roll_rate_invalid, DiagnosticCode::roll_rate_jump},
                      Failing{"RollAngle", &rsi::Inputs::roll_angle_rad, -2.0F, 0.05F,
                              DiagnosticCode::roll_angle_invalid, DiagnosticCode::roll_angle_jump},
                      Failing{"YawRate", &rsi::Inputs::yaw_rate_radps, -4.1F, 0.21F,
                              DiagnosticCode::yaw_rate_invalid, DiagnosticCode::yaw_rate_jump},
                      Failing{"Speed", &rsi::Inputs::speed_mps, 98.0F, 1.6F, DiagnosticCode::speed_invalid,
                              DiagnosticCode::speed_jump},
                      Failing{"SteeringWheelAngle", &rsi::Inputs::steering_wheel_angle_rad, -16.0F, 2.1F,
                              DiagnosticCode::steering_invalid, DiagnosticCode::steering_jump}),
    [](const auto& tested) { return std::string{tested.param.name}; });

// A steering wheel that stands where it has jumped to, or beyond its range, while a turn begins.
TEST_F(ASteadyTurn, IsNotHeldAgainstASteeringWheelThatFailsByItself) {
    struct Elsewhere {
        float angle_rad;
        DiagnosticCode code;
    };
    for (const Elsewhere& elsewhere : {Elsewhere{3.5F, DiagnosticCode::steering_jump},
                                       Elsewhere{16.0F, DiagnosticCode::steering_invalid}}) {
        monitor.start(rsi_test_large_suv());
        memory = {};
        inputs.steering_wheel_angle_rad = 1.0F;
        turn_at(0.0F);
        run(5);
        inputs.steering_wheel_angle_rad = elsewhere.angle_rad;
        run(30);
        ASSERT_TRUE(memory.confirmed(elsewhere.code));
        turn_at(5.0F);
        run(5);
        EXPECT_EQ(memory.status(DiagnosticCode::steering_stuck), EventStatus::none);
    }
}

// The counterpart: a wheel that has failed in no other way.
TEST_F(ASteadyTurn, IsHeldAgainstASteeringWheelThatHasNotMovedSinceTheStraight) {
    monitor.start(rsi_test_large_suv());
    turn_at(0.0F);
    run(25);
    EXPECT_EQ(qualified.steering_wheel_angle_rad, inputs.steering_wheel_angle_rad);
    turn_at(5.0F);
    run(1);
    EXPECT_TRUE(memory.confirmed(DiagnosticCode::steering_stuck));
    EXPECT_TRUE(std::isnan(qualified.steering_wheel_angle_rad));
    turn_at(0.0F);
    run(500);  // nor does the straight clear it
    for (int cycle = 0; cycle < 20; ++cycle) {
        EXPECT_TRUE(memory.confirmed(DiagnosticCode::steering_stuck)) << cycle;
        inputs.steering_wheel_angle_rad += 0.001F;
        run(1);
    }
    EXPECT_FALSE(memory.confirmed(DiagnosticCode::steering_stuck));
}

TEST_F(ASteadyTurn, DoesNotClearASteeringWheelThatSaysNothing) {
    monitor.start(rsi_test_large_suv());
    turn_at(0.0F);
    run(25);
    turn_at(5.0F);
    run(1);
    ASSERT_TRUE(memory.confirmed(DiagnosticCode::steering_stuck));
    const float held_rad = inputs.steering_wheel_angle_rad;
    for (int time = 0; time < 50; ++time) {
        inputs.steering_wheel_angle_rad = std::numeric_limits<float>::quiet_NaN();
        run(1);
        inputs.steering_wheel_angle_rad = held_rad;
        run(10);
    }
    EXPECT_TRUE(memory.confirmed(DiagnosticCode::steering_stuck));
}

// An offset that has been found does not vanish because a warning allows more.
TEST_F(ASteadyTurn, DoesNotClearTheVerticalAccelerationByAWarning) {
    inputs.vertical_specific_force_mps2 += 2.0F;
    run(200);
    ASSERT_TRUE(memory.confirmed(DiagnosticCode::vertical_acceleration_offset));
    before.state = RSI_STATE_WARNING;
    run(500);
    EXPECT_TRUE(memory.confirmed(DiagnosticCode::vertical_acceleration_offset));
    inputs.vertical_specific_force_mps2 -= 2.0F;
    run(250);
    EXPECT_FALSE(memory.confirmed(DiagnosticCode::vertical_acceleration_offset));
}

// In a warning wheels lift and come down.
TEST_F(ASteadyTurn, AllowsMoreOfTheVerticalAccelerationInAWarningThanBefore) {
    struct Allowed {
        rsi_state state;
        float offset_mps2;
    };
    for (const Allowed& allowed : {Allowed{RSI_STATE_READY, 1.5F}, Allowed{RSI_STATE_ADVISORY, 1.5F},
                                   Allowed{RSI_STATE_WARNING, 3.5F}, Allowed{RSI_STATE_UNAVAILABLE, 3.5F}}) {
        const float usual = inputs.vertical_specific_force_mps2;
        before.state = allowed.state;
        for (const float share : {0.99F, 1.01F}) {
            monitor.start(rsi_test_large_suv());
            memory = {};
            inputs.vertical_specific_force_mps2 = usual + share * allowed.offset_mps2;
            run(500);
            EXPECT_EQ(memory.confirmed(DiagnosticCode::vertical_acceleration_offset), share > 1.0F);
            EXPECT_EQ(std::isnan(qualified.vertical_specific_force_mps2), share > 1.0F);
        }
        inputs.vertical_specific_force_mps2 = usual;
    }
}

}  // namespace
}  // namespace monitoring_reference_test
