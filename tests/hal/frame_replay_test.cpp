// Behaviour of the frame replay, and of the virtual clock that it moves.
#include "hal/memory/frame_replay.hpp"

#include <gtest/gtest.h>

#include <array>

#include "hal/memory/memory_bus.hpp"
#include "tests/hal/make_frame.hpp"

namespace rsi::hal {
namespace {

using testing::make_frame_at;

constexpr Time milliseconds(std::int64_t count) {
    return Time::from_milliseconds(count);
}

class FrameReplayTest : public ::testing::Test {
 protected:
    const std::array<CanFrame, 4> recorded{
        make_frame_at(milliseconds(0), 1U), make_frame_at(milliseconds(10), 2U),
        make_frame_at(milliseconds(13), 3U), make_frame_at(milliseconds(20), 4U)};
    VirtualClock clock;
    MemoryBus<2U> bus{clock};
    FrameReplay replay{recorded.data(), recorded.size(), clock, bus.endpoint(0U)};
    CanFrame frame;

    void expect_received(std::uint32_t identifier, Time time) {
        ASSERT_EQ(bus.endpoint(1U).receive(frame), ReceiveResult::frame);
        EXPECT_EQ(frame.identifier, identifier);
        EXPECT_EQ(frame.receive_time, time);
    }
    void expect_empty() { EXPECT_EQ(bus.endpoint(1U).receive(frame), ReceiveResult::empty); }
};

TEST_F(FrameReplayTest, FramesAreDeliveredWhenDueAndNotBefore) {
    EXPECT_EQ(replay.run_until(milliseconds(9)), 1U);
    expect_received(1U, milliseconds(0));
    expect_empty();
    EXPECT_EQ(replay.run_until(milliseconds(10)), 1U);
    expect_received(2U, milliseconds(10));
    expect_empty();
}

TEST_F(FrameReplayTest, FramesBetweenTwoStepsKeepTheirRecordedTimes) {
    EXPECT_EQ(replay.run_until(milliseconds(19)), 3U);
    expect_received(1U, milliseconds(0));
    expect_received(2U, milliseconds(10));
    expect_received(3U, milliseconds(13));
    expect_empty();
}

TEST_F(FrameReplayTest, TheClockStandsAtTheTimeAskedForAfterwards) {
    replay.run_until(milliseconds(15));
    EXPECT_EQ(clock.now(), milliseconds(15));
    replay.run_until(milliseconds(40));
    EXPECT_EQ(clock.now(), milliseconds(40));
}

TEST_F(FrameReplayTest, ItIsFinishedOnceTheLastFrameIsSent) {
    replay.run_until(milliseconds(19));
    EXPECT_FALSE(replay.finished());
    EXPECT_EQ(replay.run_until(milliseconds(20)), 1U);
    EXPECT_TRUE(replay.finished());
    EXPECT_EQ(replay.run_until(milliseconds(1000)), 0U);
}

TEST_F(FrameReplayTest, FramesOfTheOthersAreReadAtTheReplayingEndpoint) {
    replay.run_until(milliseconds(10));
    bus.endpoint(1U).send(make_frame_at(Time{}, 0x77U));
    ASSERT_EQ(bus.endpoint(0U).receive(frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x77U);
    EXPECT_EQ(frame.receive_time, milliseconds(10));
    EXPECT_EQ(bus.endpoint(0U).receive(frame), ReceiveResult::empty);  // not its own replayed frames
}

TEST(VirtualClock, StandsStillUntilMoved) {
    VirtualClock clock(milliseconds(3));
    EXPECT_EQ(clock.now(), milliseconds(3));
    EXPECT_TRUE(clock.advance(milliseconds(4)));
    EXPECT_EQ(clock.now(), milliseconds(7));
    EXPECT_TRUE(clock.set(milliseconds(20)));
    EXPECT_EQ(clock.now(), milliseconds(20));
}

TEST(VirtualClock, NeverGoesBack) {
    VirtualClock clock(milliseconds(3));
    EXPECT_FALSE(clock.set(milliseconds(2)));
    EXPECT_FALSE(clock.advance(milliseconds(-1)));
    EXPECT_EQ(clock.now(), milliseconds(3));
    EXPECT_TRUE(clock.set(milliseconds(3)));
}

}  // namespace
}  // namespace rsi::hal
