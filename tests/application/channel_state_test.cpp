// Channels that damage many of their frames, though not all: they are not used, and come back when they are
// good.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "rsi/ecu/application/frame_monitor.hpp"
#include "tests/application/bench.hpp"
#include "tests/application/end_to_end.hpp"

namespace testing_application {
namespace {

using rsi::can_dbc::e2e::ChannelState;
using State = rsi::can_dbc::RolloverWarning::State;

class DamagingChannel : public ::testing::TestWithParam<Sensor> {
 protected:
    void SetUp() override {
        bench.run_for(0.5);  // the observer knows the roll angle, too
        ASSERT_EQ(bench.state(), State::ready);
    }

    void run_cycle(bool damaged) {
        bench.tamper(sensor, {});
        if (damaged) {
            bench.tamper(sensor, [](rsi::hal::CanFrame& frame) { frame.data[4] ^= 0x08U; });
        }
        bench.run_cycles(1);
    }

    // Two frames of three are damaged: a good one every 30 ms, so that no value is older than the limit.
    void run_two_of_three_damaged(int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            run_cycle(cycle % 3 != 0);
        }
    }

    bool timed_out(const Cycle& cycle) const {
        const rsi::can_dbc::RolloverStatus& status = cycle.status.value;
        const std::array<bool, 3> flags{status.imu_timeout, status.roll_angle_timeout,
                                        status.vehicle_motion_timeout};
        return flags[static_cast<std::size_t>(sensor)];
    }
    bool timed_out() const { return timed_out(bench.last()); }

    Sensor sensor{GetParam()};
    Bench bench;
};

TEST_P(DamagingChannel, IsNotUsedAlthoughSomeFramesAreGood) {
    run_two_of_three_damaged(8);
    const std::size_t from = bench.cycles().size();
    run_two_of_three_damaged(60);
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        const Cycle& cycle = bench.cycles()[index];
        ASSERT_TRUE(timed_out(cycle)) << "cycle " << index;
        ASSERT_EQ(cycle.state(), sensor == Sensor::imu ? State::unavailable : State::ready)
            << "cycle " << index;
    }
}

TEST_P(DamagingChannel, IsUsedWhileNoMoreThanFourOfEightFramesAreDamaged) {
    for (int cycle = 0; cycle < 80; ++cycle) {
        run_cycle(cycle % 8 == 1 || cycle % 8 == 2 || cycle % 8 == 4 || cycle % 8 == 6);
        ASSERT_FALSE(timed_out()) << "cycle " << cycle;
        ASSERT_EQ(bench.state(), State::ready) << "cycle " << cycle;
    }
}

TEST_P(DamagingChannel, IsNotUsedAgainBeforeItIsClearlyBetter) {
    run_two_of_three_damaged(24);
    ASSERT_TRUE(timed_out());
    for (int cycle = 0; cycle < 40; ++cycle) {
        run_cycle(cycle % 2 == 0);  // which a channel that is valid may do
        ASSERT_TRUE(timed_out()) << "cycle " << cycle;
    }
    run_cycle(false);  // three of the last eight were damaged
    run_cycle(false);
    ASSERT_TRUE(timed_out());
    run_cycle(false);
    run_cycle(false);
    EXPECT_FALSE(timed_out());
    bench.run_for(0.2);
    EXPECT_EQ(bench.state(), State::ready);
}

INSTANTIATE_TEST_SUITE_P(OfEachSensor, DamagingChannel, ::testing::ValuesIn(all_sensors),
                         [](const auto& tested) { return std::string{name_of(tested.param)}; });

// One monitor by itself, on a clock of its own.
class Monitor : public ::testing::Test {
 protected:
    rsi::hal::CanFrame frame() {
        rsi::hal::CanFrame frame;
        frame.identifier = rsi::can_dbc::Imu::identifier;
        frame.length = rsi::can_dbc::Imu::length;
        const auto payload = rsi::can_dbc::encode(rsi::can_dbc::Imu{1.0F, 9.8F, 0.0F});
        std::copy(payload.begin(), payload.end(), frame.data.begin());
        protect(frame, rsi::can_dbc::Imu::e2e_data_id, counter);
        counter = (counter + 1U) % 15U;
        frame.receive_time = now;
        return frame;
    }

    void run_cycle(bool with_frame) {
        now = now + rsi::hal::Time::from_milliseconds(10);
        monitor.begin_cycle();
        if (with_frame) {
            monitor.take(frame());
        }
    }

    unsigned counter{0U};
    rsi::hal::Time now{};
    rsi::application::FrameMonitor<rsi::can_dbc::Imu> monitor{};
};

TEST_F(Monitor, KnowsNothingAtTheStart) {
    EXPECT_EQ(monitor.channel_state(), ChannelState::no_data);
    EXPECT_FALSE(monitor.is_fresh(now));
    run_cycle(false);
    EXPECT_EQ(monitor.channel_state(), ChannelState::no_data);
}

TEST_F(Monitor, UsesTheFirstGoodFrame) {
    run_cycle(false);
    run_cycle(true);
    EXPECT_EQ(monitor.channel_state(), ChannelState::valid);
    EXPECT_TRUE(monitor.is_fresh(now));
}

TEST_F(Monitor, LeavesSilenceToTheTimeLimit) {
    for (int frames = 1; frames <= 20; ++frames) {
        run_cycle(true);
        const rsi::hal::Time last = now;
        const rsi::hal::Time limit = last + rsi::application::frame_time_limit;
        for (int silent = 1; silent <= 12; ++silent) {
            run_cycle(false);
            EXPECT_EQ(monitor.is_fresh(now), !(limit < now)) << silent << " cycles after frame " << frames;
            if (silent <= 3) {
                EXPECT_TRUE(monitor.is_fresh(limit));
            }
        }
        EXPECT_EQ(monitor.channel_state(), ChannelState::invalid);
    }
}

TEST_F(Monitor, UsesTheFirstFrameInSequenceAfterASilence) {
    run_cycle(true);
    for (int silent = 0; silent < 20; ++silent) {
        run_cycle(false);
    }
    ASSERT_EQ(monitor.channel_state(), ChannelState::invalid);
    counter = (counter + 7U) % 15U;  // counted by the sender meanwhile
    run_cycle(true);
    EXPECT_FALSE(monitor.is_fresh(now));
    run_cycle(true);
    EXPECT_TRUE(monitor.is_fresh(now));
    EXPECT_EQ(monitor.channel_state(), ChannelState::valid);
}

TEST_F(Monitor, ForgetsWhatAnInvalidChannelHasSaid) {
    for (int cycle = 0; cycle < 8; ++cycle) {
        run_cycle(true);
    }
    ASSERT_TRUE(monitor.is_fresh(now));
    for (int damaged = 0; damaged < 5; ++damaged) {  // all within the time limit of the last good frame
        rsi::hal::CanFrame bad = frame();
        bad.data[2] ^= 1U;
        EXPECT_TRUE(monitor.is_fresh(now)) << damaged;
        monitor.take(bad);
    }
    EXPECT_EQ(monitor.channel_state(), ChannelState::invalid);
    EXPECT_FALSE(monitor.is_fresh(now));
}

// The damaged frames leave the window in cycles without a frame.
TEST_F(Monitor, ForgetsItAlsoWhenTheChannelIsValidAgainBeforeAnotherFrameCame) {
    for (int cycle = 0; cycle < 8; ++cycle) {
        run_cycle(true);
    }
    const rsi::hal::Time last_good = now;
    for (int damaged = 0; damaged < 5; ++damaged) {
        rsi::hal::CanFrame bad = frame();
        bad.data[2] ^= 1U;
        monitor.take(bad);
    }
    for (int good = 0; good < 3; ++good) {  // too few, and not used
        monitor.take(frame());
        ASSERT_EQ(monitor.channel_state(), ChannelState::invalid);
    }
    for (int silent = 0; silent < 4; ++silent) {
        run_cycle(false);
    }
    ASSERT_EQ(monitor.channel_state(), ChannelState::valid);
    EXPECT_FALSE(monitor.is_fresh(last_good));
}

}  // namespace
}  // namespace testing_application
