// One channel's monitor by itself: what it keeps, and how it uses the rate of its frames.
#include "rsi/ecu/application/frame_monitor.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

constexpr unsigned counter_values = 15U;

class AFrameMonitor : public ::testing::Test {
 protected:
    // A cycle with so many good frames, one after the other.
    void cycle(int frames) {
        now = now + rsi::hal::Time::from_milliseconds(10);
        monitor.begin_cycle();
        for (int index = 0; index < frames; ++index) {
            rsi::hal::CanFrame frame =
                frame_of(rsi::can_dbc::RollAngle{3.0F, rsi::can_dbc::not_available}, counter);
            frame.receive_time = now;
            monitor.take(frame);
            counter = (counter + 1U) % counter_values;
        }
    }

    void cycles(int count, int frames) {
        for (int index = 0; index < count; ++index) {
            cycle(frames);
        }
    }

    rsi::application::FrameMonitor<rsi::can_dbc::RollAngle> monitor{};
    rsi::hal::Time now{};
    unsigned counter{0U};
};

// That there are two is known when the cycle has ended, and from then on what they said is not used: not even
// while it is younger than the time limit.
TEST_F(AFrameMonitor, WithdrawsTheLastValueWhenTheSendersTurnOutToBeTwo) {
    cycles(100, 1);
    cycles(12, 2);
    ASSERT_FALSE(monitor.has_two_senders());
    ASSERT_TRUE(monitor.is_fresh(now));
    monitor.begin_cycle();
    ASSERT_TRUE(monitor.has_two_senders());
    EXPECT_FALSE(monitor.is_fresh(now));
}

TEST_F(AFrameMonitor, KnowsThatFramesWaitedWhileCyclesWereMissed) {
    for (const std::uint32_t missed : {0U, 32U}) {
        monitor = {};
        cycles(100, 1);
        monitor.miss_cycles(missed);
        cycles(6, 4);
        EXPECT_EQ(monitor.has_two_senders(), missed == 0U);
    }
}

TEST_F(AFrameMonitor, CountsNoDamagedFramesAsThoseOfASecondSender) {
    for (int index = 0; index < 300; ++index) {
        cycle(1);
        rsi::hal::CanFrame damaged =
            frame_of(rsi::can_dbc::RollAngle{3.0F, rsi::can_dbc::not_available}, counter);
        damaged.data[4] ^= 0x08U;
        monitor.take(damaged);
        ASSERT_FALSE(monitor.has_two_senders()) << "cycle " << index;
    }
}

}  // namespace
}  // namespace testing_application
