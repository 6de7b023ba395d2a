// Behaviour of the in-memory bus.
#include "hal/memory/memory_bus.hpp"

#include <gtest/gtest.h>

#include "hal/memory/virtual_clock.hpp"
#include "tests/hal/make_frame.hpp"

namespace rsi::hal {
namespace {

using testing::make_frame;

class MemoryBusTest : public ::testing::Test {
 protected:
    VirtualClock clock{Time::from_milliseconds(5)};
    MemoryBus<3U, 4U> bus{clock};
    MemoryBus<3U, 4U>::Endpoint& sender{bus.endpoint(0U)};
    MemoryBus<3U, 4U>::Endpoint& receiver{bus.endpoint(1U)};
    MemoryBus<3U, 4U>::Endpoint& other{bus.endpoint(2U)};
    CanFrame frame;
};

TEST_F(MemoryBusTest, EveryOtherEndpointReceivesWhatOneSends) {
    ASSERT_EQ(sender.send(make_frame(0x123U, {1U, 2U, 3U})), SendResult::sent);
    for (auto* endpoint : {&receiver, &other}) {
        ASSERT_EQ(endpoint->receive(frame), ReceiveResult::frame);
        EXPECT_EQ(frame.identifier, 0x123U);
        EXPECT_EQ(frame.length, 3U);
        EXPECT_EQ(frame.data[2], 3U);
        EXPECT_EQ(endpoint->receive(frame), ReceiveResult::empty);
    }
}

TEST_F(MemoryBusTest, AFrameArrivesWhole) {
    CanFrame sent = make_frame(0x1ABC'DEF0U);
    sent.extended = true;
    sent.flexible_data_rate = true;
    sent.length = 64U;
    for (std::size_t byte = 0U; byte < sent.data.size(); ++byte) {
        sent.data[byte] = static_cast<std::uint8_t>(byte + 1U);
    }
    ASSERT_EQ(sender.send(sent), SendResult::sent);
    ASSERT_EQ(receiver.receive(frame), ReceiveResult::frame);
    EXPECT_TRUE(frame.extended);
    EXPECT_TRUE(frame.flexible_data_rate);
    EXPECT_EQ(frame.length, 64U);
    EXPECT_EQ(frame.data, sent.data);
}

TEST_F(MemoryBusTest, NoEndpointReceivesItsOwnFrames) {
    ASSERT_EQ(sender.send(make_frame(1U)), SendResult::sent);
    EXPECT_EQ(sender.receive(frame), ReceiveResult::empty);
}

TEST_F(MemoryBusTest, FramesOfAnySenderArriveInTheOrderOfSending) {
    sender.send(make_frame(3U));
    other.send(make_frame(1U));
    sender.send(make_frame(2U));
    for (const std::uint32_t expected : {3U, 1U, 2U}) {
        ASSERT_EQ(receiver.receive(frame), ReceiveResult::frame);
        EXPECT_EQ(frame.identifier, expected);
    }
}

TEST_F(MemoryBusTest, OrderHoldsAcrossTheEndOfTheRing) {
    for (std::uint32_t identifier = 0U; identifier < 11U; ++identifier) {
        sender.send(make_frame(identifier));
        sender.send(make_frame(identifier + 100U));
        ASSERT_EQ(receiver.receive(frame), ReceiveResult::frame);
        EXPECT_EQ(frame.identifier, identifier);
        ASSERT_EQ(receiver.receive(frame), ReceiveResult::frame);
        EXPECT_EQ(frame.identifier, identifier + 100U);
    }
}

TEST_F(MemoryBusTest, FramesCarryTheTimeOfSendingNotOfReading) {
    sender.send(make_frame(1U));
    clock.set(Time::from_milliseconds(9));
    ASSERT_EQ(receiver.receive(frame), ReceiveResult::frame);
    EXPECT_EQ(frame.receive_time, Time::from_milliseconds(5));
}

TEST_F(MemoryBusTest, AFullEndpointLosesTheNewestFramesAndCountsThem) {
    for (std::uint32_t identifier = 0U; identifier < 7U; ++identifier) {
        EXPECT_EQ(sender.send(make_frame(identifier)), SendResult::sent);
    }
    for (std::uint32_t identifier = 0U; identifier < 4U; ++identifier) {
        ASSERT_EQ(receiver.receive(frame), ReceiveResult::frame);
        EXPECT_EQ(frame.identifier, identifier);
    }
    EXPECT_EQ(receiver.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(receiver.statistics().frames_lost, 3U);
    EXPECT_EQ(receiver.statistics().frames_received, 4U);
    EXPECT_EQ(sender.statistics().frames_sent, 7U);
    EXPECT_EQ(sender.statistics().frames_lost, 0U);
}

TEST_F(MemoryBusTest, AReceiverWithRoomIsNotHurtByOneWithout) {
    for (std::uint32_t identifier = 0U; identifier < 6U; ++identifier) {
        sender.send(make_frame(identifier));
        ASSERT_EQ(other.receive(frame), ReceiveResult::frame);
        EXPECT_EQ(frame.identifier, identifier);
    }
    EXPECT_EQ(other.statistics().frames_lost, 0U);
    EXPECT_EQ(receiver.statistics().frames_lost, 2U);
}

TEST_F(MemoryBusTest, AnEmptyReceiveLeavesTheFrameAlone) {
    frame = make_frame(0x7FFU, {9U});
    ASSERT_EQ(receiver.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(frame.identifier, 0x7FFU);
    EXPECT_EQ(frame.data[0], 9U);
}

TEST_F(MemoryBusTest, FramesThatNoControllerCanSendAreRefused) {
    CanFrame nine_bytes = make_frame(1U);
    nine_bytes.length = 9U;
    EXPECT_EQ(sender.send(nine_bytes), SendResult::failed);
    EXPECT_EQ(sender.send(make_frame(0x800U)), SendResult::failed);
    EXPECT_EQ(sender.statistics().send_failures, 2U);
    EXPECT_EQ(receiver.receive(frame), ReceiveResult::empty);
}

TEST_F(MemoryBusTest, ABusOffEndpointNeitherSendsNorHears) {
    receiver.set_state(BusState::bus_off);
    EXPECT_EQ(receiver.state(), BusState::bus_off);
    EXPECT_EQ(receiver.send(make_frame(1U)), SendResult::failed);
    sender.send(make_frame(2U));
    EXPECT_EQ(receiver.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(receiver.statistics().frames_lost, 0U);  // it did not listen, so it lost nothing

    receiver.set_state(BusState::error_active);
    sender.send(make_frame(3U));
    ASSERT_EQ(receiver.receive(frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 3U);
}

TEST_F(MemoryBusTest, AnErrorPassiveEndpointStillTakesPart) {
    receiver.set_state(BusState::error_passive);
    EXPECT_EQ(receiver.send(make_frame(1U)), SendResult::sent);
    sender.send(make_frame(2U));
    EXPECT_EQ(receiver.receive(frame), ReceiveResult::frame);
}

TEST_F(MemoryBusTest, AClosedEndpointFailsBothWays) {
    sender.send(make_frame(1U));
    receiver.set_state(BusState::closed);
    EXPECT_EQ(receiver.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(receiver.send(make_frame(2U)), SendResult::failed);
}

}  // namespace
}  // namespace rsi::hal
