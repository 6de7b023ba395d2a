// Reactions of the ECU to implausible sensors: by itself each frame is good, but the values cannot be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

#include "tests/application/bench.hpp"
#include "tests/application/roll_plane_vehicle.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;
using Code = rsi::can_dbc::RolloverDiagnosis::Code;
using CodeStatus = rsi::can_dbc::RolloverDiagnosis::CodeStatus;
using Degradation = rsi::can_dbc::RolloverDiagnosis::Degradation;

// Slow enough for no warning, fast enough that everything moves.
double slalom_mps2(double time_s) {
    return 4.0 * std::sin(2.0 * time_s);
}

// A slalom whose sensors can be falsified, `delay_s` after its start.
struct Slalom {
    explicit Slalom(std::function<void(Motion&, double)> falsify) {
        bench.drive([this, falsify](double time_s) {
            vehicle.advance(slalom_mps2(time_s));
            Motion motion = vehicle.motion();
            noise_kmh = -noise_kmh;  // a speed without any may stand still
            motion.vehicle_motion.speed_kmh += noise_kmh;
            if (faulty) {
                falsify(motion, time_s);
            }
            return motion;
        });
        bench.run_for(3.0);
    }

    bool confirmed_since(std::size_t from, Code code) const {
        for (std::size_t index = from; index < bench.cycles().size(); ++index) {
            const rsi::can_dbc::RolloverDiagnosis& diagnosis = bench.cycles()[index].diagnosis.value;
            if (diagnosis.code == code && diagnosis.code_status == CodeStatus::confirmed) {
                return true;
            }
        }
        return false;
    }

    bool faulty{false};
    float noise_kmh{0.05F};
    Bench bench;
    RollPlaneVehicle vehicle{large_suv()};
};

struct Lie {
    const char* name;
    std::function<void(Motion&, double)> falsify;
    Code code;
    Degradation degradation;
    double at_the_latest_s;
};

void PrintTo(const Lie& lie, std::ostream* out) {
    *out << lie.name;
}

class ALie : public ::testing::TestWithParam<Lie> {};

TEST_P(ALie, IsConfirmedDegradesAsStatedAndHeals) {
    const Lie& lie = GetParam();
    Slalom slalom{lie.falsify};
    EXPECT_EQ(slalom.bench.last().diagnosis.value.degradation, Degradation::full);
    ASSERT_EQ(slalom.bench.last().diagnosis.value.code, Code::none) << "before the fault";
    const std::size_t from = slalom.bench.cycles().size();

    slalom.faulty = true;
    slalom.bench.run_for(lie.at_the_latest_s);
    EXPECT_TRUE(slalom.confirmed_since(from, lie.code));
    const rsi::can_dbc::RolloverDiagnosis& diagnosis = slalom.bench.last().diagnosis.value;
    EXPECT_EQ(diagnosis.degradation, lie.degradation) << static_cast<int>(diagnosis.degradation);
    EXPECT_EQ(slalom.bench.state() == State::unavailable, lie.degradation == Degradation::unavailable);
    EXPECT_GE(diagnosis.occurrences, 1U);

    slalom.faulty = false;
    slalom.bench.run_for(4.0);
    EXPECT_EQ(slalom.bench.last().diagnosis.value.degradation, Degradation::full);
    EXPECT_EQ(slalom.bench.last().diagnosis.value.code_status, CodeStatus::healed);
}

std::function<void(Motion&, double)> frozen(float& (*signal)(Motion&)) {
    return [signal, first = true, value = 0.0F](Motion& motion, double) mutable {
        value = first ? signal(motion) : value;
        first = false;
        signal(motion) = value;
    };
}

float& lateral(Motion& motion) {
    return motion.imu.lateral_acceleration_mps2;
}
float& roll_rate(Motion& motion) {
    return motion.imu.roll_rate_deg_per_s;
}
float& roll_angle(Motion& motion) {
    return motion.roll_angle.roll_angle_deg;
}
float& yaw_rate(Motion& motion) {
    return motion.vehicle_motion.yaw_rate_deg_per_s;
}
float& speed(Motion& motion) {
    return motion.vehicle_motion.speed_kmh;
}

float& vertical(Motion& motion) {
    return motion.imu.vertical_acceleration_mps2;
}
float& steering(Motion& motion) {
    return motion.vehicle_motion.steering_wheel_angle_deg;
}
float& bank(Motion& motion) {
    return motion.roll_angle.bank_angle_deg;
}

std::function<void(Motion&, double)> shifted(float& (*signal)(Motion&), float by) {
    return [signal, by](Motion& motion, double) { signal(motion) += by; };
}

std::function<void(Motion&, double)> turned_over(float& (*signal)(Motion&)) {
    return [signal](Motion& motion, double) { signal(motion) = -signal(motion); };
}

std::function<void(Motion&, double)> set_to(float& (*signal)(Motion&), float value) {
    return [signal, value](Motion& motion, double) { signal(motion) = value; };
}

std::function<void(Motion&, double)> shaken(float& (*signal)(Motion&), float by) {
    return [signal, by, up = false](Motion& motion, double) mutable {
        up = !up;
        signal(motion) += up ? by : -by;
    };
}

INSTANTIATE_TEST_SUITE_P(
    OfOneSensor, ALie,
    ::testing::Values(
        Lie{"LateralAccelerationSaturated", set_to(lateral, 60.0F), Code::lateral_acceleration_invalid,
            Degradation::unavailable, 0.05},
        Lie{"RollRateSaturated", set_to(roll_rate, -300.0F), Code::roll_rate_invalid,
            Degradation::unavailable, 0.05},
        Lie{"RollAngleSaturated", set_to(roll_angle, 120.0F), Code::roll_angle_invalid,
            Degradation::roll_sensor_lost, 0.05},
        Lie{"YawRateSaturated", set_to(yaw_rate, 300.0F), Code::yaw_rate_invalid, Degradation::motion_lost,
            0.05},
        Lie{"SpeedSaturated", set_to(speed, 400.0F), Code::speed_invalid, Degradation::motion_lost, 0.05},
        Lie{"LateralAccelerationInABurstOfNoise", shaken(lateral, 15.0F), Code::lateral_acceleration_jump,
            Degradation::unavailable, 0.05},
        Lie{"RollRateInABurstOfNoise", shaken(roll_rate, 50.0F), Code::roll_rate_jump,
            Degradation::unavailable, 0.05},
        Lie{"RollAngleInABurstOfNoise", shaken(roll_angle, 6.0F), Code::roll_angle_jump,
            Degradation::roll_sensor_lost, 0.05},
        Lie{"LateralAccelerationFrozen", frozen(lateral), Code::lateral_acceleration_stuck,
            Degradation::unavailable, 1.0},
        Lie{"RollAngleFrozen", frozen(roll_angle), Code::roll_angle_stuck, Degradation::roll_sensor_lost,
            1.0},
        Lie{"YawRateFrozen", frozen(yaw_rate), Code::yaw_rate_stuck, Degradation::motion_lost, 1.0},
        Lie{"SpeedFrozen", frozen(speed), Code::speed_stuck, Degradation::motion_lost, 2.0},
        Lie{"VerticalAccelerationSaturated", set_to(vertical, 60.0F), Code::vertical_acceleration_invalid,
            Degradation::full, 0.05},
        Lie{"VerticalAccelerationInABurstOfNoise", shaken(vertical, 4.0F), Code::vertical_acceleration_jump,
            Degradation::full, 0.3},
        Lie{"VerticalAccelerationFrozen", frozen(vertical), Code::vertical_acceleration_stuck,
            Degradation::full, 1.0},
        Lie{"VerticalAccelerationOffset", shifted(vertical, 4.0F), Code::vertical_acceleration_offset,
            Degradation::full, 0.5},
        Lie{"VerticalAccelerationOfTheWrongSign", turned_over(vertical), Code::vertical_acceleration_jump,
            Degradation::full, 0.5},
        Lie{"RollRateFrozen", frozen(roll_rate), Code::roll_rate_stuck, Degradation::unavailable, 1.0},
        Lie{"RollRateOffset", shifted(roll_rate, 15.0F), Code::roll_rate_offset, Degradation::unavailable,
            1.2},
        Lie{"RollRateOfTheWrongSign", turned_over(roll_rate), Code::roll_rate_offset,
            Degradation::unavailable, 2.0},
        Lie{"RollAngleOffset", shifted(roll_angle, 4.0F), Code::roll_angle_jump,
            Degradation::roll_sensor_lost, 0.3},
        Lie{"LateralAccelerationOffset", shifted(lateral, 4.0F),
            Code::lateral_acceleration_contradicts_yaw_rate, Degradation::unavailable, 1.5},
        Lie{"LateralAccelerationOfTheWrongSign", turned_over(lateral),
            Code::lateral_acceleration_contradicts_yaw_rate, Degradation::unavailable, 1.5},
        Lie{"SteeringSaturated", set_to(steering, 1200.0F), Code::steering_invalid, Degradation::full, 0.05},
        Lie{"SteeringInABurstOfNoise", shaken(steering, 60.0F), Code::steering_jump, Degradation::full, 0.3},
        Lie{"SpeedInABurstOfNoise", shaken(speed, 30.0F), Code::speed_jump, Degradation::motion_lost, 0.3},
        Lie{"YawRateInABurstOfNoise", shaken(yaw_rate, 20.0F), Code::yaw_rate_jump, Degradation::motion_lost,
            0.3},
        Lie{"BankAngleSaturated", set_to(bank, 45.0F), Code::bank_angle_invalid, Degradation::full, 0.05}),
    [](const auto& tested) { return std::string{tested.param.name}; });

TEST(ARollSensor, ThatContradictsTheObserverIsInvalidatedUntilTheyAgreeForASecond) {
    Bench bench;
    bench.run_for(3.0);
    Motion motion;
    motion.roll_angle.roll_angle_deg = 12.0F;  // on a straight road
    bench.drive(motion);
    bench.run_for(1.0);
    EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::roll_sensor_lost);
    EXPECT_EQ(bench.state(), State::ready);
    bench.drive(Motion{});
    bench.run_for(0.9);
    EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::roll_sensor_lost);
    bench.run_for(1.5);
    EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::full);
}

// Straight on, then a turn; what the steering and the yaw rate say of it is falsified.
struct FalsifiedTurn {
    explicit FalsifiedTurn(std::function<void(Motion&)> falsify) {
        bench.drive([this, falsify](double time_s) {
            vehicle.advance(time_s < 2.0 ? 0.0 : std::min(4.0, 8.0 * (time_s - 2.0)));
            Motion motion = vehicle.motion();
            falsify(motion);
            return motion;
        });
    }

    bool told(Code code) const {
        return std::any_of(bench.cycles().begin(), bench.cycles().end(), [code](const Cycle& cycle) {
            return cycle.diagnosis.value.code == code &&
                   cycle.diagnosis.value.code_status == CodeStatus::confirmed;
        });
    }

    Bench bench;
    RollPlaneVehicle vehicle{large_suv()};
};

TEST(AFrozenSteeringWheel, IsFoundInTheFirstTurn) {
    FalsifiedTurn turn{[](Motion& motion) { steering(motion) = 0.0F; }};
    turn.bench.run_for(2.3);
    EXPECT_FALSE(turn.told(Code::steering_stuck));
    turn.bench.run_for(0.4);
    EXPECT_TRUE(turn.told(Code::steering_stuck));
    EXPECT_TRUE(std::isnan(turn.bench.inputs().steering_wheel_angle_rad));
}

TEST(AYawRateOfTheWrongSign, IsFoundInAHeldTurn) {
    FalsifiedTurn turn{[](Motion& motion) { yaw_rate(motion) = -yaw_rate(motion); }};
    turn.bench.run_for(3.2);
    EXPECT_FALSE(turn.told(Code::yaw_rate_contradicts_lateral_acceleration));
    turn.bench.run_for(1.0);
    EXPECT_TRUE(turn.told(Code::yaw_rate_contradicts_lateral_acceleration));
    EXPECT_EQ(turn.bench.last().diagnosis.value.degradation, Degradation::motion_lost);
}

// A small offset of the lateral acceleration must not cost the roll sensor.
TEST(AnOffsetOfTheLateralAcceleration, DoesNotBlameTheRollSensor) {
    for (const float offset : {2.0F, -2.0F, 2.4F, -2.4F, 3.0F, -3.0F, 5.0F, -5.0F}) {
        SCOPED_TRACE(offset);
        FalsifiedTurn turn{[offset](Motion& motion) { lateral(motion) += offset; }};
        turn.bench.run_for(4.0);
        EXPECT_FALSE(turn.told(Code::roll_sensor_contradicts_observer));
    }
}

// One that is large enough to hide a turn must be found, whichever way it goes.
TEST(AnOffsetOfTheLateralAcceleration, ThatIsLargeTakesItOutWithinASecond) {
    for (const float offset : {4.0F, -4.0F, 6.0F, -6.0F}) {
        SCOPED_TRACE(offset);
        bool faulty = false;
        FalsifiedTurn turn{[&faulty, offset](Motion& motion) { lateral(motion) += faulty ? offset : 0.0F; }};
        turn.bench.run_for(4.0);
        faulty = true;
        turn.bench.run_for(0.9);
        EXPECT_TRUE(turn.told(Code::lateral_acceleration_contradicts_yaw_rate));
        EXPECT_EQ(turn.bench.state(), State::unavailable);
    }
}

// A weave near the limit: the tyres slide, and the yaw rate is ahead of the lateral acceleration by 0.3 s.
double fast_weave_mps2(double time_s) {
    return 6.0 * std::sin(1.65 * time_s);
}

TEST(ALateralAccelerationOfTheWrongSign, ThatIsRightAgainIsAcceptedInAWeave) {
    const auto run = [](double flipped_from_s, double flipped_to_s, double until_s) {
        Bench bench;
        RollPlaneVehicle vehicle{large_suv()};
        bench.drive([&vehicle, flipped_from_s, flipped_to_s](double time_s) {
            vehicle.advance(fast_weave_mps2(time_s));
            Motion motion = vehicle.motion();
            motion.vehicle_motion.yaw_rate_deg_per_s = 57.29578F * 3.6F *
                                                       static_cast<float>(fast_weave_mps2(time_s + 0.3)) /
                                                       motion.vehicle_motion.speed_kmh;
            if (time_s >= flipped_from_s && time_s < flipped_to_s) {
                motion.imu.lateral_acceleration_mps2 *= -1.0F;
            }
            return motion;
        });
        bench.run_for(until_s);
        return bench.state();
    };
    EXPECT_NE(run(9.0, 9.0, 10.0), State::unavailable) << "without the fault";
    for (double now_s = 4.8; now_s < 12.0; now_s += 0.3) {
        ASSERT_EQ(run(3.8, 12.0, now_s), State::unavailable) << "not healed at " << now_s;
    }
    EXPECT_NE(run(3.8, 6.0, 10.0), State::unavailable);
}

// Two faults at once: the second must not clear the first.
TEST(ALieThatIsFound, IsNotAcceptedAfterAStall) {
    Slalom slalom{[](Motion& motion, double) { roll_rate(motion) += 12.0F; }};
    slalom.faulty = true;
    slalom.bench.run_for(2.0);
    ASSERT_EQ(slalom.bench.state(), State::unavailable);
    slalom.bench.miss_cycles(3U);
    slalom.bench.run_cycles(1);
    slalom.bench.miss_cycles(0U);
    for (int cycle = 0; cycle < 2000; ++cycle) {
        slalom.bench.run_cycles(1);
        ASSERT_EQ(slalom.bench.state(), State::unavailable) << cycle;
    }
    slalom.faulty = false;
    slalom.bench.run_for(4.0);
    EXPECT_NE(slalom.bench.state(), State::unavailable);
}

TEST(ALieThatIsFound, IsNotAcceptedWithoutItsReference) {
    Slalom slalom{frozen(lateral)};
    slalom.faulty = true;
    slalom.bench.run_for(1.0);
    ASSERT_EQ(slalom.bench.state(), State::unavailable);
    slalom.bench.stop(Sensor::vehicle_motion);
    for (int cycle = 0; cycle < 1000; ++cycle) {
        slalom.bench.run_cycles(1);
        ASSERT_EQ(slalom.bench.state(), State::unavailable) << cycle;
    }
    slalom.bench.resume(Sensor::vehicle_motion);
    slalom.faulty = false;
    slalom.bench.run_for(4.0);
    EXPECT_NE(slalom.bench.state(), State::unavailable);
}

TEST(GoodSensors, OfATurnSetNoCode) {
    FalsifiedTurn turn{[](Motion&) {}};
    turn.bench.run_for(4.0);
    for (const Cycle& cycle : turn.bench.cycles()) {
        ASSERT_EQ(cycle.diagnosis.value.code, Code::none);
    }
}

TEST(GoodSensors, OfASlalomSetNoCode) {
    const Slalom slalom{[](Motion&, double) {}};
    for (const Cycle& cycle : slalom.bench.cycles()) {
        ASSERT_EQ(cycle.diagnosis.value.code, Code::none);
    }
}

}  // namespace
}  // namespace testing_application
