// Frames that are not what they should be: wrong length, damaged, of another kind, of another node.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/application/bench.hpp"
#include "tests/application/end_to_end.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;

bool checksum_error(const rsi::can_dbc::RolloverStatus& status, Sensor sensor) {
    switch (sensor) {
        case Sensor::imu:
            return status.imu_checksum_error;
        case Sensor::roll_angle:
            return status.roll_angle_checksum_error;
        case Sensor::vehicle_motion:
            return status.vehicle_motion_checksum_error;
    }
    return false;
}

bool timeout(const rsi::can_dbc::RolloverStatus& status, Sensor sensor) {
    switch (sensor) {
        case Sensor::imu:
            return status.imu_timeout;
        case Sensor::roll_angle:
            return status.roll_angle_timeout;
        case Sensor::vehicle_motion:
            return status.vehicle_motion_timeout;
    }
    return false;
}

class DamagedFrames : public ::testing::TestWithParam<Sensor> {
 protected:
    void SetUp() override {
        bench.run_for(0.5);  // the observer knows the roll angle, too
        ASSERT_EQ(bench.state(), State::ready);
    }

    // Every frame of the sensor is changed for a while: each one must be rejected, the flag set, the sensor
    // taken for silent, and nothing of it remembered when the frames are good again.
    void expect_refused(const Bench::FrameChange& change) {
        const unsigned before = bench.status().frames_rejected;
        bench.tamper(sensor, change);
        for (int cycle = 1; cycle <= 6; ++cycle) {
            bench.run_cycles(1);
            ASSERT_TRUE(checksum_error(bench.status(), sensor));
            ASSERT_EQ(bench.status().frames_rejected, std::min(before + static_cast<unsigned>(cycle), 255U));
        }
        ASSERT_TRUE(timeout(bench.status(), sensor));
        ASSERT_EQ(bench.state(), sensor == Sensor::imu ? State::unavailable : State::ready);
        recover();
    }

    // The same for frames that are not even taken for the sensor's: no error, but silence.
    void expect_ignored(const Bench::FrameChange& change) {
        const unsigned before = bench.status().frames_rejected;
        bench.tamper(sensor, change);
        bench.run_cycles(6);
        EXPECT_FALSE(checksum_error(bench.status(), sensor));
        EXPECT_EQ(bench.status().frames_rejected, before);
        EXPECT_TRUE(timeout(bench.status(), sensor));
        recover();
    }

    void recover() {
        bench.tamper(sensor, {});
        bench.run_for(0.2);
        ASSERT_FALSE(checksum_error(bench.status(), sensor));
        ASSERT_EQ(bench.state(), State::ready);
    }

    Sensor sensor{GetParam()};
    Bench bench;
};

TEST_P(DamagedFrames, OfEachWrongLengthAreRefused) {
    for (unsigned length = 0U; length < 8U; ++length) {
        SCOPED_TRACE("length " + std::to_string(length));
        expect_refused(
            [length](rsi::hal::CanFrame& frame) { frame.length = static_cast<std::uint8_t>(length); });
    }
}

TEST_P(DamagedFrames, WithAnySingleBitFlippedAreRefused) {
    for (unsigned bit = 0U; bit < 64U; ++bit) {
        SCOPED_TRACE("bit " + std::to_string(bit));
        expect_refused([bit](rsi::hal::CanFrame& frame) {
            frame.data[bit / 8U] = static_cast<std::uint8_t>(frame.data[bit / 8U] ^ (1U << (bit % 8U)));
        });
    }
}

TEST_P(DamagedFrames, WithAnotherDataIdentifierAreRefused) {
    // The low byte alone, which only the checksum knows, the nibble alone, and a whole other message's.
    for (const int data_id : {0x3A6, 0x4A7, 0x45D, 0x35C, 0x5B0, 0x4B1, 0x61E, 0x000}) {
        SCOPED_TRACE("data identifier " + std::to_string(data_id));
        expect_refused([data_id](rsi::hal::CanFrame& frame) {
            protect(frame, static_cast<std::uint16_t>(data_id), counter_of(frame));
        });
    }
}

TEST_P(DamagedFrames, ThatCarryAnotherMessagesPayloadAreRefused) {
    const Sensor other = all_sensors[(static_cast<std::size_t>(sensor) + 1U) % all_sensors.size()];
    expect_refused([this, other](rsi::hal::CanFrame& frame) { frame.data = bench.last_frame(other).data; });
}

TEST_P(DamagedFrames, OfOneCycleOnlyDoNotInterruptTheWarning) {
    for (int time = 0; time < 20; ++time) {
        bench.tamper(sensor, [](rsi::hal::CanFrame& frame) { frame.data[0] ^= 0xFFU; });
        bench.run_cycles(1);
        EXPECT_TRUE(checksum_error(bench.status(), sensor));
        EXPECT_EQ(bench.state(), State::ready);
        bench.tamper(sensor, {});
        bench.run_cycles(1);
        EXPECT_FALSE(checksum_error(bench.status(), sensor));
        EXPECT_EQ(bench.state(), State::ready);
    }
    EXPECT_EQ(bench.status().frames_lost, 20U);
}

// The flag is of the whole cycle, not of its last frame; the values are those of the good one.
TEST_P(DamagedFrames, BeforeAGoodOneInTheSameCycleAreStillReported) {
    rsi::hal::CanFrame damaged = bench.last_frame(sensor);
    damaged.data[3] = static_cast<std::uint8_t>(damaged.data[3] ^ 0x01U);
    bench.send_foreign(damaged);
    bench.run_cycles(1);
    EXPECT_TRUE(checksum_error(bench.status(), sensor));
    EXPECT_FALSE(timeout(bench.status(), sensor));
    bench.run_cycles(1);
    EXPECT_FALSE(checksum_error(bench.status(), sensor));
    EXPECT_EQ(bench.state(), State::ready);
}

TEST_P(DamagedFrames, OfCanFdAreIgnored) {
    expect_ignored([](rsi::hal::CanFrame& frame) { frame.flexible_data_rate = true; });
}

TEST_P(DamagedFrames, WithAnExtendedIdentifierAreIgnored) {
    expect_ignored([](rsi::hal::CanFrame& frame) { frame.extended = true; });
}

INSTANTIATE_TEST_SUITE_P(OfEachSensor, DamagedFrames, ::testing::ValuesIn(all_sensors),
                         [](const auto& tested) { return std::string{name_of(tested.param)}; });

rsi::hal::CanFrame mass_frame(unsigned counter, bool damaged) {
    rsi::hal::CanFrame frame = frame_of(rsi::can_dbc::VehicleMass{2500.0F}, counter);
    frame.data[0] ^= damaged ? 1U : 0U;
    return frame;
}

// Five of the last eight withdraw what it says; those before a silence of eight cycles no longer count.
TEST(DamagedFramesOfTheVehiclesMass, AreCountedAndForgottenInSilence) {
    Bench bench;
    bench.run_until_ready();
    const auto mass_kg_after = [&bench](const rsi::hal::CanFrame& frame) {
        bench.send_foreign(frame);
        bench.run_cycles(1);
        return bench.inputs().vehicle_mass_kg;
    };
    EXPECT_EQ(mass_kg_after(mass_frame(0U, false)), 2500.0F);
    for (unsigned counter = 1U; counter <= 5U; ++counter) {
        mass_kg_after(mass_frame(counter, true));
    }
    EXPECT_EQ(bench.status().frames_rejected, 5U);
    EXPECT_TRUE(std::isnan(mass_kg_after(mass_frame(6U, false))));
    bench.run_cycles(8);
    EXPECT_EQ(mass_kg_after(mass_frame(7U, false)), 2500.0F);
}

TEST(ForeignFrames, OfEveryOtherIdentifierAreIgnored) {
    Bench bench;
    bench.run_until_ready();
    const std::vector<rsi::hal::CanFrame> quiet = bench.last().frames;
    for (std::uint32_t identifier = 0U; identifier <= 0x7FFU; ++identifier) {
        if (identifier >= rsi::can_dbc::Imu::identifier &&
            identifier <= rsi::can_dbc::VehicleMass::identifier) {
            continue;
        }
        rsi::hal::CanFrame frame = bench.last_frame(Sensor::imu);
        frame.identifier = identifier;
        bench.send_foreign(frame);
        if (identifier % 32U == 31U) {
            bench.run_cycles(1);
            ASSERT_EQ(bench.state(), State::ready) << identifier;
            ASSERT_EQ(bench.status().frames_rejected, 0U) << identifier;
        }
    }
    EXPECT_EQ(bench.last().frames.size(), quiet.size());
}

TEST(ForeignFrames, InAFloodDoNotStopTheCycle) {
    Bench bench;
    bench.run_until_ready();
    rsi::hal::CanFrame foreign;
    foreign.identifier = 0x001U;
    foreign.length = 8U;
    const std::size_t from = bench.cycles().size();
    for (int cycle = 0; cycle < 100; ++cycle) {
        for (int count = 0; count < 1000; ++count) {
            bench.send_foreign(foreign);
        }
        bench.run_cycles(1);
    }
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        ASSERT_EQ(bench.cycles()[index].frames.size(), frames_per_cycle);
    }
    // The controller has lost frames, the sensors' among them: no statement is better than an old one.
    EXPECT_TRUE(bench.status().receive_overflow);
    EXPECT_TRUE(bench.status().imu_timeout);
    EXPECT_EQ(bench.state(), State::unavailable);
    bench.run_for(0.3);
    EXPECT_FALSE(bench.status().receive_overflow);
    EXPECT_EQ(bench.state(), State::ready);
}

// A bus on which the next foreign frame is always there already.
class EndlessBus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        frame = rsi::hal::CanFrame{};
        return ++received > 1'000'000U ? rsi::hal::ReceiveResult::empty : rsi::hal::ReceiveResult::frame;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame&) noexcept override {
        ++sent;
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }

    std::uint32_t received{0U};
    std::uint32_t sent{0U};
};

TEST(ForeignFrames, WithoutEndAreLeftWaitingAfterABoundedNumber) {
    EndlessBus bus;
    const rsi::hal::VirtualClock clock;
    NoWatchdog watchdog;
    rsi::application::RolloverEcu ecu{bus, clock, watchdog};
    ecu.init(large_suv());
    ecu.step(0U);
    EXPECT_LE(bus.received, 256U);
    EXPECT_EQ(bus.sent, frames_per_cycle);
}

// 500 kbit/s carry 45 frames of eight bytes in 10 ms.
TEST(ForeignFrames, ThatFillABusOf500KilobitsLeaveTheWarningAvailable) {
    Bench bench;
    rsi::hal::CanFrame foreign;
    foreign.identifier = 0x001U;
    foreign.length = 8U;
    for (int cycle = 0; cycle < 300; ++cycle) {
        for (int count = 0; count < 42; ++count) {
            bench.send_foreign(foreign);
        }
        bench.run_cycles(1);
    }
    EXPECT_EQ(bench.state(), State::ready);
    EXPECT_FALSE(bench.status().receive_overflow);
}

}  // namespace
}  // namespace testing_application
