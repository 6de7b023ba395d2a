// Another node that sends a sensor's frames, protected as the sensor's own are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>

#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using Diagnosis = rsi::can_dbc::RolloverDiagnosis;
using State = rsi::can_dbc::RolloverWarning::State;

constexpr int longest_use_cycles = 14;  // of a second sender of the same rate
constexpr unsigned counters = 15U;

// Time of the foreign frames relative to the genuine one's.
enum class Manner : std::uint8_t { same_counter_before, next_counter_after, own_counter, tenfold };
constexpr const char* name_of(Manner manner) {
    constexpr std::array<const char*, 4> names{"SameCounterBefore", "NextCounterAfter", "OwnCounter",
                                               "Tenfold"};
    return names[static_cast<std::size_t>(manner)];
}

rsi::hal::CanFrame strangers_frame(Sensor sensor, unsigned counter) {
    switch (sensor) {
        case Sensor::imu:
            return frame_of(rsi::can_dbc::Imu{1.0F, 9.5F, 2.0F}, counter);
        case Sensor::roll_angle:
            return frame_of(rsi::can_dbc::RollAngle{1.0F, rsi::can_dbc::not_available}, counter);
        case Sensor::vehicle_motion:
            return frame_of(rsi::can_dbc::VehicleMotion{82.0F, 1.0F, 5.0F}, counter);
    }
    return {};
}

std::uint16_t data_id_of(const rsi::hal::CanFrame& frame) {
    const bool is_imu = frame.identifier == rsi::can_dbc::Imu::identifier;
    const bool is_roll_angle = frame.identifier == rsi::can_dbc::RollAngle::identifier;
    return is_imu          ? rsi::can_dbc::Imu::e2e_data_id
           : is_roll_angle ? rsi::can_dbc::RollAngle::e2e_data_id
                           : rsi::can_dbc::VehicleMotion::e2e_data_id;
}

Diagnosis::Code two_senders_of(Sensor sensor) {
    constexpr std::array codes{Diagnosis::Code::imu_two_senders, Diagnosis::Code::roll_angle_two_senders,
                               Diagnosis::Code::vehicle_motion_two_senders};
    return codes[static_cast<std::size_t>(sensor)];
}

Diagnosis::Degradation lost(Sensor sensor) {
    constexpr std::array degradations{Diagnosis::Degradation::unavailable,
                                      Diagnosis::Degradation::roll_sensor_lost,
                                      Diagnosis::Degradation::motion_lost};
    return degradations[static_cast<std::size_t>(sensor)];
}

bool is_used(const rsi::Inputs& inputs, Sensor sensor) {
    switch (sensor) {
        case Sensor::imu:
            return std::isfinite(inputs.lateral_specific_force_mps2) ||
                   std::isfinite(inputs.vertical_specific_force_mps2) ||
                   std::isfinite(inputs.roll_rate_radps);
        case Sensor::roll_angle:
            return std::isfinite(inputs.roll_angle_rad);
        case Sensor::vehicle_motion:
            return std::isfinite(inputs.speed_mps) || std::isfinite(inputs.yaw_rate_radps) ||
                   std::isfinite(inputs.steering_wheel_angle_rad);
    }
    return true;
}

bool is_any(Diagnosis::Code code) {
    return code == two_senders_of(Sensor::imu) || code == two_senders_of(Sensor::roll_angle) ||
           code == two_senders_of(Sensor::vehicle_motion);
}

bool sets_code(const Bench& bench) {
    return std::any_of(bench.cycles().begin(), bench.cycles().end(),
                       [](const Cycle& cycle) { return is_any(cycle.diagnosis.value.code); });
}

bool tells(const Bench& bench, std::size_t from, Diagnosis::Code code, Diagnosis::CodeStatus status) {
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        const Diagnosis& told = bench.cycles()[index].diagnosis.value;
        if (told.code == code && told.code_status == status) {
            return true;
        }
    }
    return false;
}

class ASecondSender : public ::testing::TestWithParam<std::tuple<Sensor, Manner>> {
 protected:
    void SetUp() override {
        bench.run_for(0.5);  // the observer knows the roll angle, too
        ASSERT_EQ(bench.state(), State::ready);
    }

    void start() {
        bench.tamper(sensor, [this](rsi::hal::CanFrame& genuine) { send_beside(genuine); });
    }

    // The result of `genuine` is sent last.
    void send_beside(rsi::hal::CanFrame& genuine) {
        const unsigned counter = genuine.data[1] & 0x0FU;
        switch (manner) {
            case Manner::same_counter_before:
                bench.send_foreign(strangers_frame(sensor, counter));
                break;
            case Manner::next_counter_after:
                bench.send_foreign(genuine);
                genuine = strangers_frame(sensor, (counter + 1U) % counters);
                break;
            case Manner::own_counter:
                bench.send_foreign(strangers_frame(sensor, next_counter()));
                break;
            case Manner::tenfold:
                for (int count = 0; count < 10; ++count) {
                    bench.send_foreign(strangers_frame(sensor, next_counter()));
                }
                break;
        }
    }

    unsigned next_counter() {
        counter_ = (counter_ + 1U) % counters;
        return counter_;
    }

    Sensor sensor{std::get<0>(GetParam())};
    Manner manner{std::get<1>(GetParam())};
    Bench bench;

 private:
    unsigned counter_{6U};
};

TEST_P(ASecondSender, IsFoundWithin120MillisecondsAndNeitherIsUsedAsLongAsThereAreTwo) {
    const std::size_t from = bench.cycles().size();
    start();
    bench.run_cycles(longest_use_cycles);
    EXPECT_TRUE(tells(bench, from, two_senders_of(sensor), Diagnosis::CodeStatus::confirmed));
    for (int cycle = 0; cycle < 300; ++cycle) {
        ASSERT_FALSE(is_used(bench.inputs(), sensor)) << "cycle " << cycle;
        ASSERT_EQ(bench.last().diagnosis.value.degradation, lost(sensor)) << "cycle " << cycle;
        ASSERT_EQ(bench.state(), sensor == Sensor::imu ? State::unavailable : State::ready);
        bench.run_cycles(1);
    }
}

TEST_P(ASecondSender, IsNoLongerHeldAgainstTheGenuineOneSomeTimeAfterItHasStopped) {
    start();
    bench.run_for(2.0);
    bench.tamper(sensor, {});
    bench.run_for(0.4);
    EXPECT_FALSE(is_used(bench.inputs(), sensor));
    const std::size_t from = bench.cycles().size();
    bench.run_for(0.25);
    EXPECT_TRUE(is_used(bench.inputs(), sensor));
    bench.run_for(1.5);
    EXPECT_TRUE(tells(bench, from, two_senders_of(sensor), Diagnosis::CodeStatus::healed));
    EXPECT_EQ(bench.last().diagnosis.value.degradation, Diagnosis::Degradation::full);
    EXPECT_EQ(bench.state(), State::ready);
}

TEST_P(ASecondSender, OfOneFrameIsNoReasonToDoWithoutTheOthers) {
    const Sensor other = sensor == Sensor::imu ? Sensor::roll_angle : Sensor::imu;
    start();
    bench.run_for(1.0);
    EXPECT_TRUE(is_used(bench.inputs(), other));
    EXPECT_FALSE(tells(bench, 0U, two_senders_of(other), Diagnosis::CodeStatus::confirmed));
}

INSTANTIATE_TEST_SUITE_P(OfEachFrameInEachManner, ASecondSender,
                         ::testing::Combine(::testing::ValuesIn(all_sensors),
                                            ::testing::Values(Manner::same_counter_before,
                                                              Manner::next_counter_after, Manner::own_counter,
                                                              Manner::tenfold)),
                         [](const auto& tested) {
                             return std::string{name_of(std::get<0>(tested.param))} +
                                    name_of(std::get<1>(tested.param));
                         });

// Another node repeats the sensor's frames: whichever is used, it is the same.
TEST(ASensor, WhoseFramesAreSentTwiceOverIsUsed) {
    for (const Sensor sensor : all_sensors) {
        Bench bench;
        bench.tamper(sensor, [&bench](rsi::hal::CanFrame& frame) { bench.send_foreign(frame); });
        bench.run_for(3.0);
        EXPECT_FALSE(sets_code(bench));
        EXPECT_TRUE(is_used(bench.inputs(), sensor));
        EXPECT_EQ(bench.state(), State::ready);
    }
}

// No code tells of it, as of nothing else about the mass.
TEST(ASecondSenderOfTheMass, IsNotUsedEither) {
    Bench bench;
    Motion motion;
    motion.vehicle_mass.mass_kg = 2500.0F;
    bench.drive(motion);
    bench.run_for(0.5);
    ASSERT_TRUE(std::isfinite(bench.inputs().vehicle_mass_kg));
    unsigned counter = 0U;
    for (int cycle = 0; cycle < longest_use_cycles; ++cycle) {
        bench.send_foreign(frame_of(rsi::can_dbc::VehicleMass{3500.0F}, counter));
        counter = (counter + 1U) % counters;
        bench.run_cycles(1);
    }
    EXPECT_FALSE(std::isfinite(bench.inputs().vehicle_mass_kg));
    EXPECT_EQ(bench.state(), State::ready);
    bench.run_for(0.65);
    EXPECT_TRUE(std::isfinite(bench.inputs().vehicle_mass_kg));
}

// With any content and any protection.
TEST(AForeignNode, IsReportedAtOnceAndForASecondIfItSendsFramesOfThisControlUnit) {
    constexpr auto code = Diagnosis::Code::own_identifier_received;
    for (const std::uint32_t identifier : rsi::application::sent_identifiers) {
        Bench bench;
        bench.run_for(0.5);
        rsi::hal::CanFrame frame;
        frame.identifier = identifier;
        frame.length = 8U;
        const std::size_t from = bench.cycles().size();
        EXPECT_FALSE(tells(bench, 0U, code, Diagnosis::CodeStatus::confirmed));
        bench.send_foreign(frame);
        frame.identifier = rsi::can_dbc::RolloverWarning::identifier + 1U;
        bench.send_foreign(frame);  // another node's, behind it in the same cycle
        bench.run_cycles(1);
        EXPECT_TRUE(tells(bench, from, code, Diagnosis::CodeStatus::confirmed)) << identifier;
        EXPECT_EQ(bench.state(), State::ready) << "what the component says is as true as before";
        bench.run_cycles(99);
        EXPECT_FALSE(tells(bench, from, code, Diagnosis::CodeStatus::healed)) << identifier;
        bench.run_cycles(2);
        EXPECT_TRUE(tells(bench, from, code, Diagnosis::CodeStatus::healed)) << identifier;
    }
}

TEST(AForeignNode, IsNotASenderOfFramesOfOtherKinds) {
    Bench bench;
    rsi::hal::CanFrame of_another_identifier;
    of_another_identifier.identifier = rsi::can_dbc::RolloverWarning::identifier + 1U;
    rsi::hal::CanFrame extended;
    extended.identifier = rsi::can_dbc::RolloverWarning::identifier;
    extended.extended = true;
    rsi::hal::CanFrame flexible;
    flexible.identifier = rsi::can_dbc::RolloverWarning::identifier;
    flexible.flexible_data_rate = true;
    for (const rsi::hal::CanFrame& frame : {of_another_identifier, extended, flexible}) {
        bench.send_foreign(frame);
        bench.run_cycles(2);
    }
    EXPECT_FALSE(
        tells(bench, 0U, Diagnosis::Code::own_identifier_received, Diagnosis::CodeStatus::confirmed));
}

// More frames than a cycle reads.
TEST(AStalledCycle, ThatFindsTheFramesOf640MillisecondsSetsNoCode) {
    Bench bench;
    bench.run_for(0.5);
    for (const Sensor sensor : all_sensors) {
        bench.tamper(sensor, [&bench](rsi::hal::CanFrame& frame) {
            const std::uint16_t data_id = data_id_of(frame);
            const unsigned counter = frame.data[1] & 0x0FU;
            for (unsigned count = 0U; count < 63U; ++count) {
                protect(frame, data_id, (counter + count) % counters);
                bench.send_foreign(frame);
            }
            protect(frame, data_id, (counter + 63U) % counters);
        });
    }
    bench.move_clock(rsi::hal::Time::from_milliseconds(630));
    bench.miss_cycles(63U);
    bench.run_cycles(1);
    for (const Sensor sensor : all_sensors) {
        bench.tamper(sensor, {});
        bench.lose_frames(sensor, 63U);
    }
    bench.miss_cycles(0U);
    bench.run_for(3.0);
    EXPECT_FALSE(sets_code(bench));
    EXPECT_EQ(bench.state(), State::ready);
}

// Each further one reads two frames of each sender.
TEST(AnEcuThatMissesEverySecondCycle, SetsNoCode) {
    Bench bench;
    bench.run_for(0.5);
    unsigned counter = 0U;
    for (const Sensor sensor : all_sensors) {
        bench.tamper(sensor, [&bench, &counter](rsi::hal::CanFrame& frame) {
            protect(frame, data_id_of(frame), counter);
            bench.send_foreign(frame);
            protect(frame, data_id_of(frame), (counter + 1U) % counters);
        });
    }
    bench.miss_cycles(1U);
    for (int cycle = 0; cycle < 300; ++cycle) {
        bench.send_foreign(frame_of(rsi::can_dbc::VehicleMass{2500.0F}, counter));
        bench.send_foreign(frame_of(rsi::can_dbc::VehicleMass{2500.0F}, (counter + 1U) % counters));
        bench.run_cycles(1);
        counter = (counter + 2U) % counters;
    }
    EXPECT_FALSE(sets_code(bench));
    for (const Sensor sensor : all_sensors) {
        EXPECT_TRUE(is_used(bench.inputs(), sensor)) << name_of(sensor);
    }
    EXPECT_TRUE(std::isfinite(bench.inputs().vehicle_mass_kg));
}

// A damaged frame has no sender.

}  // namespace
}  // namespace testing_application
