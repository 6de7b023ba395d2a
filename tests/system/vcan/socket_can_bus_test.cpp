// SocketCanBus on a virtual CAN interface: frames, filters, times, overflow, and what can go wrong.
#include "hal/socketcan/socket_can_bus.hpp"

#include <gtest/gtest.h>
#include <linux/can.h>

#include <algorithm>
#include <array>

#include "tests/hal/make_frame.hpp"
#include "tests/system/vcan/interface_fixture.hpp"

namespace rsi::hal {
namespace {

using testing::make_frame;

class SocketCanBusTest : public testing::InterfaceTest {};

TEST_F(SocketCanBusTest, FramesPassBothWays) {
    ASSERT_EQ(first.send(make_frame(0x123U, {1U, 2U, 3U})), SendResult::sent);
    ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x123U);
    EXPECT_FALSE(frame.extended);
    EXPECT_FALSE(frame.flexible_data_rate);
    EXPECT_EQ(frame.length, 3U);
    EXPECT_EQ(frame.data[2], 3U);

    CanFrame answer = make_frame(0x1ABC'DEF0U, {9U});
    answer.extended = true;
    ASSERT_EQ(second.send(answer), SendResult::sent);
    ASSERT_EQ(receive_soon(first, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x1ABC'DEF0U);
    EXPECT_TRUE(frame.extended);
    EXPECT_EQ(frame.data[0], 9U);

    EXPECT_EQ(first.statistics().frames_sent, 1U);
    EXPECT_EQ(first.statistics().frames_received, 1U);
    EXPECT_EQ(first.statistics().frames_lost, 0U);
    EXPECT_EQ(first.state(), BusState::error_active);
}

TEST_F(SocketCanBusTest, FramesKeepTheirOrder) {
    for (std::uint32_t identifier = 0U; identifier < 500U; ++identifier) {
        ASSERT_EQ(first.send(make_frame(identifier)), SendResult::sent);
    }
    for (std::uint32_t identifier = 0U; identifier < 500U; ++identifier) {
        ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
        ASSERT_EQ(frame.identifier, identifier);
    }
    EXPECT_EQ(second.statistics().frames_lost, 0U);
}

TEST_F(SocketCanBusTest, OwnFramesDoNotComeBack) {
    first.send(make_frame(1U));
    ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);  // so it has been on the bus by now
    EXPECT_EQ(first.receive(frame), ReceiveResult::empty);
}

TEST_F(SocketCanBusTest, OwnFramesComeBackWhenAskedFor) {
    SocketCanSettings settings;
    settings.receive_own_frames = true;
    open_or_fail(first, settings);
    first.send(make_frame(0x42U));
    ASSERT_EQ(receive_soon(first, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x42U);
}

TEST_F(SocketCanBusTest, OnlyTheIdentifiersAskedForAreReceived) {
    const std::array<CanIdentifier, 2> wanted{CanIdentifier{0x100U, false}, CanIdentifier{0x200U, true}};
    SocketCanSettings settings;
    settings.identifiers = wanted.data();
    settings.identifier_count = wanted.size();
    open_or_fail(second, settings);

    CanFrame extended_wanted = make_frame(0x200U);
    extended_wanted.extended = true;
    CanFrame extended_foreign = make_frame(0x100U);
    extended_foreign.extended = true;
    first.send(make_frame(0x101U));            // a neighbour
    first.send(extended_foreign);              // the right number in the other identifier length
    first.send(make_frame(0x200U));            // likewise
    testing::send_raw(0x100U | CAN_RTR_FLAG);  // a remote frame
    first.send(make_frame(0x100U));
    first.send(extended_wanted);

    ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x100U);
    EXPECT_FALSE(frame.extended);
    ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x200U);
    EXPECT_TRUE(frame.extended);
    EXPECT_EQ(second.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(second.statistics().frames_received, 2U);
}

TEST_F(SocketCanBusTest, RemoteFramesAreNotReceivedWithoutFiltersEither) {
    testing::send_raw(0x100U | CAN_RTR_FLAG);
    testing::send_raw(0x101U);
    ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x101U);
}

TEST_F(SocketCanBusTest, AnEmptyBusReturnsAtOnceAndLeavesTheFrameAlone) {
    frame = make_frame(0x7FFU, {9U});
    Time shortest = Time::from_milliseconds(1000);  // a busy machine may hold up single calls
    for (int i = 0; i < 100; ++i) {
        const Time before = clock.now();
        ASSERT_EQ(first.receive(frame), ReceiveResult::empty);  // a blocking call would never end
        shortest = std::min(shortest, clock.now() - before);
    }
    EXPECT_LT(shortest, Time::from_milliseconds(10));
    EXPECT_EQ(frame.identifier, 0x7FFU);
    EXPECT_EQ(frame.data[0], 9U);
}

TEST_F(SocketCanBusTest, WaitingEndsWhenItsTimeIsUp) {
    const Time before = clock.now();
    EXPECT_FALSE(first.wait_for_frame(Time::from_milliseconds(5)));
    EXPECT_FALSE(clock.now() - before < Time::from_milliseconds(5));
}

TEST_F(SocketCanBusTest, ReceiveTimesLieBetweenSendingAndReceiving) {
    for (int i = 0; i < 50; ++i) {
        const Time before = clock.now();
        ASSERT_EQ(first.send(make_frame(1U)), SendResult::sent);
        ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
        const Time after = clock.now();
        EXPECT_FALSE(frame.receive_time < before);
        EXPECT_FALSE(after < frame.receive_time);
    }
}

TEST_F(SocketCanBusTest, ReceiveTimesTellWhenTheFrameCameNotWhenItWasRead) {
    Time least_late = Time::from_milliseconds(1000);
    for (int i = 0; i < 10; ++i) {
        first.send(make_frame(1U));
        ASSERT_TRUE(second.wait_for_frame(longest_wait));
        const Time arrived = clock.now();
        clock.wait_until(arrived + Time::from_milliseconds(20));
        ASSERT_EQ(second.receive(frame), ReceiveResult::frame);
        least_late = std::min(least_late, frame.receive_time - arrived);
    }
    // Reading the two clocks one after the other may cost some microseconds, and a busy machine may hold the
    // reader up between them; 20 ms are to be seen each time, not those.
    EXPECT_LT(least_late, Time::from_milliseconds(10));
}

TEST_F(SocketCanBusTest, FlexibleDataRateFramesPass) {
    CanFrame large = make_frame(0x55U);
    large.flexible_data_rate = true;
    large.length = 64U;
    for (std::uint8_t i = 0U; i < 64U; ++i) {
        large.data[i] = static_cast<std::uint8_t>(3U * i);
    }
    ASSERT_EQ(first.send(large), SendResult::sent);
    ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
    EXPECT_TRUE(frame.flexible_data_rate);
    EXPECT_EQ(frame.length, 64U);
    EXPECT_EQ(frame.data, large.data);
}

TEST_F(SocketCanBusTest, AClassicInterfaceRefusesFlexibleDataRateFramesAndStaysUsable) {
    testing::set_interface_mtu(CAN_MTU);
    open_or_fail(first);
    open_or_fail(second);
    CanFrame large = make_frame(0x55U);
    large.flexible_data_rate = true;
    EXPECT_EQ(first.send(large), SendResult::failed);
    EXPECT_EQ(first.statistics().send_failures, 1U);
    EXPECT_EQ(first.state(), BusState::error_active);
    EXPECT_EQ(first.send(make_frame(0x55U)), SendResult::sent);
    EXPECT_EQ(receive_soon(second, frame), ReceiveResult::frame);
}

TEST_F(SocketCanBusTest, FramesThatNoControllerCanSendAreRefused) {
    CanFrame nine_bytes = make_frame(1U);
    nine_bytes.length = 9U;
    EXPECT_EQ(first.send(nine_bytes), SendResult::failed);
    EXPECT_EQ(first.send(make_frame(0x800U)), SendResult::failed);
    EXPECT_EQ(first.statistics().send_failures, 2U);
}

TEST_F(SocketCanBusTest, EveryFrameThatAReaderWasTooSlowForIsCounted) {
    constexpr std::uint32_t flood{1000U};
    SocketCanSettings settings;
    settings.receive_buffer_bytes = 1;  // the kernel makes it as small as it can
    open_or_fail(second, settings);
    for (std::uint32_t identifier = 0U; identifier < flood; ++identifier) {
        ASSERT_EQ(first.send(make_frame(identifier)), SendResult::sent);
    }
    std::uint32_t received = 0U;
    while (second.receive(frame) == ReceiveResult::frame) {
        EXPECT_EQ(frame.identifier, received);  // the oldest are kept
        ++received;
    }
    EXPECT_GT(received, 0U);
    EXPECT_LT(received, flood);

    // The kernel tells of the loss with the next frame that it can queue.
    ASSERT_EQ(first.send(make_frame(0x7FFU)), SendResult::sent);
    ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x7FFU);
    EXPECT_EQ(second.statistics().frames_received, received + 1U);
    EXPECT_EQ(second.statistics().frames_lost, flood - received);
}

TEST_F(SocketCanBusTest, TheReceiveBufferIsAsLargeAsAskedFor) {
    SocketCanSettings settings;
    settings.receive_buffer_bytes = 4 << 20;
    open_or_fail(second, settings);
    EXPECT_GE(second.receive_buffer_bytes(), 4 << 20);
}

}  // namespace
}  // namespace rsi::hal
