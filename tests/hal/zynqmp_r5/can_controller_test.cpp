// The CAN driver against a fake of the controller's registers.
#include "hal/zynqmp_r5/can_controller.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "hal/memory/virtual_clock.hpp"
#include "tests/hal/make_frame.hpp"
#include "tests/hal/zynqmp_r5/can_device.hpp"

namespace hal::zynqmp_r5::testing {
namespace {

using hal::testing::make_frame;
using Controller = CanController<FakeRegisters, SiliconCanFrameLayout>;

CanSettings three_identifiers() {
    CanSettings settings;
    settings.identifiers = {0x120U, 0x121U, 0x122U};
    settings.identifier_count = 3U;
    return settings;
}

CanFrameWords words_of(std::uint32_t identifier) {
    return SiliconCanFrameLayout::pack(make_frame(identifier, {1U, 2U, 3U}));
}

class CanControllerTest : public ::testing::Test {
 protected:
    void open() {
        ASSERT_TRUE(controller.open(three_identifiers()));
        device.writes.clear();
    }
    void pass(std::int64_t milliseconds) { clock.set(clock.now() + Time::from_milliseconds(milliseconds)); }
    std::size_t starts() const {
        return static_cast<std::size_t>(
            std::count(device.writes.begin(), device.writes.end(), Write{can::software_reset, 2U}));
    }

    VirtualClock clock;
    CanDevice device;
    Controller controller{FakeRegisters{&device}, clock};
    CanFrame frame;
};

TEST_F(CanControllerTest, OpensByTheseWritesInThisOrder) {
    ASSERT_TRUE(controller.open(three_identifiers()));
    constexpr std::uint32_t mask = 0xFFF8'0000U;
    const std::vector<Write> expected{
        {0xFF06'0000U, 1U},            // reset
        {0xFF06'0004U, 0U},            // normal mode
        {0xFF06'0008U, 9U},            // 500 kbit/s
        {0xFF06'000CU, 0x12FU},        //
        {0xFF06'0060U, 0U},            // filters off, while they are set
        {0xFF06'0064U, mask},          //
        {0xFF06'0068U, 0x2400'0000U},  //
        {0xFF06'006CU, mask},          //
        {0xFF06'0070U, 0x2420'0000U},  //
        {0xFF06'0074U, mask},          //
        {0xFF06'0078U, 0x2440'0000U},  //
        {0xFF06'0060U, 7U},            // three filters on
        {0xFF06'0020U, 0U},            // no interrupts
        {0xFF06'0024U, 0x7FFFU},       // no events
        {0xFF06'0000U, 2U},            // on the bus
    };
    EXPECT_EQ(device.writes, expected);
    EXPECT_EQ(controller.state(), BusState::error_active);
}

TEST_F(CanControllerTest, WithoutIdentifiersEveryFrameIsLetThrough) {
    ASSERT_TRUE(controller.open());
    EXPECT_EQ(device.value_of(can::filter_enable), 0U);
    device.arrive(words_of(0x7FFU));
    EXPECT_EQ(controller.receive(frame), ReceiveResult::frame);
}

TEST_F(CanControllerTest, RefusesImpossibleSettingsWithoutTouchingTheController) {
    CanSettings settings = three_identifiers();
    settings.identifiers[1] = 0x800U;
    EXPECT_FALSE(controller.open(settings));
    settings = three_identifiers();
    settings.identifier_count = 5U;
    EXPECT_FALSE(controller.open(settings));
    EXPECT_EQ(device.accesses, 0U);
    EXPECT_EQ(controller.state(), BusState::closed);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(controller.send(make_frame(0x123U, {})), SendResult::failed);
}

TEST_F(CanControllerTest, AControllerThatDoesNotRespondCostsABoundedTimeAndIsTriedAgain) {
    device.responds_to_reset = false;
    EXPECT_FALSE(controller.open(three_identifiers()));
    EXPECT_LE(device.accesses, most_can_polls + 1U);
    EXPECT_EQ(controller.state(), BusState::closed);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);

    device.responds_to_reset = true;
    pass(99);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);
    pass(1);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(controller.state(), BusState::error_active);
}

TEST_F(CanControllerTest, FiltersThatStayBusyAreNotWaitedForForEver) {
    device.filters_stay_busy = true;
    EXPECT_FALSE(controller.open(three_identifiers()));
    EXPECT_LE(device.accesses, 2U * most_can_polls);
    EXPECT_EQ(starts(), 0U);
}

TEST_F(CanControllerTest, ReceivesWhatTheFiltersLetThroughInItsOrderWithTheTimeOfReceiving) {
    open();
    device.arrive(words_of(0x120U));
    device.arrive(words_of(0x300U));
    device.arrive(words_of(0x122U));
    pass(7);
    ASSERT_EQ(controller.receive(frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x120U);
    EXPECT_EQ(frame.length, 3U);
    EXPECT_EQ(frame.data[2], 3U);
    EXPECT_EQ(frame.receive_time, Time::from_milliseconds(7));
    ASSERT_EQ(controller.receive(frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x122U);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(frame.identifier, 0x122U);  // untouched
    EXPECT_EQ(controller.statistics().frames_received, 2U);
    // Each frame taken is told to the controller, and nothing else is.
    EXPECT_EQ(device.writes, (std::vector<Write>{{0xFF06'0024U, 1U << 7U}, {0xFF06'0024U, 1U << 7U}}));
}

TEST_F(CanControllerTest, RemoteFramesAreSkipped) {
    ASSERT_TRUE(controller.open());
    device.arrive({words_of(0x120U)[0] | (1U << 20U), 0U, 0U, 0U});
    device.arrive(words_of(0x121U));
    ASSERT_EQ(controller.receive(frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x121U);
    EXPECT_EQ(controller.statistics().frames_received, 1U);
}

TEST_F(CanControllerTest, AnOverflowIsCountedOnceAndCleared) {
    open();
    for (std::size_t i = 0U; i < can::fifo_depth + 3U; ++i) {
        device.arrive(words_of(0x120U));
    }
    std::size_t received = 0U;
    while (controller.receive(frame) == ReceiveResult::frame) {
        ++received;
    }
    EXPECT_EQ(received, can::fifo_depth);
    EXPECT_EQ(controller.statistics().frames_lost, 1U);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(controller.statistics().frames_lost, 1U);
}

TEST_F(CanControllerTest, SendsByFourWritesOfWhichTheLastOneSends) {
    open();
    ASSERT_EQ(controller.send(make_frame(0x0D0U, {0x11U, 0x22U, 0x33U, 0x44U, 0x55U})), SendResult::sent);
    const std::vector<Write> expected{
        {0xFF06'0024U, 1U << 14U},     // forget that the FIFO was empty
        {0xFF06'0030U, 0x1A00'0000U},  // identifier
        {0xFF06'0034U, 0x5000'0000U},  // length
        {0xFF06'0038U, 0x1122'3344U},  //
        {0xFF06'003CU, 0x5500'0000U},  //
    };
    EXPECT_EQ(device.writes, expected);
    EXPECT_EQ(device.sent.size(), 1U);
    EXPECT_EQ(controller.statistics().frames_sent, 1U);
}

TEST_F(CanControllerTest, AFullFifoIsSaidAndNothingIsWritten) {
    open();
    device.has_bus = false;
    for (std::size_t i = 0U; i < can::fifo_depth; ++i) {
        ASSERT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::sent);
    }
    const std::size_t writes = device.writes.size();
    EXPECT_EQ(controller.send(make_frame(0x0D0U, {2U})), SendResult::full);
    EXPECT_EQ(device.writes.size(), writes);
    EXPECT_EQ(controller.statistics().send_failures, 1U);
    EXPECT_EQ(controller.statistics().frames_sent, can::fifo_depth);
}

TEST_F(CanControllerTest, RefusesWhatAClassicControllerCannotSend) {
    open();
    CanFrame fast = make_frame(0x0D0U, {1U});
    fast.flexible_data_rate = true;
    CanFrame too_long = make_frame(0x0D0U, {1U});
    too_long.length = 9U;
    for (const CanFrame& bad : {fast, too_long, make_frame(0x800U, {})}) {
        EXPECT_EQ(controller.send(bad), SendResult::failed);
    }
    EXPECT_EQ(controller.statistics().send_failures, 3U);
    EXPECT_TRUE(device.sent.empty());
}

TEST_F(CanControllerTest, FramesThatCannotLeaveAreThrownAwayInsteadOfSentLate) {
    open();
    device.has_bus = false;
    ASSERT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::sent);
    pass(50);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(device.waiting_to_leave(), 1U);
    EXPECT_EQ(controller.statistics().send_failures, 0U);
    pass(1);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(device.waiting_to_leave(), 0U);
    EXPECT_EQ(controller.statistics().send_failures, 1U);

    device.connect();
    EXPECT_TRUE(device.sent.empty());
    ASSERT_EQ(controller.send(make_frame(0x0D0U, {2U})), SendResult::sent);
    ASSERT_EQ(device.sent.size(), 1U);
    EXPECT_EQ(device.sent[0][2], 0x0200'0000U);
}

TEST_F(CanControllerTest, AFifoThatEmptiesInBetweenIsNotThrownAway) {
    open();
    for (int cycle = 0; cycle < 20; ++cycle) {
        ASSERT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::sent);
        pass(10);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::empty);
    }
    EXPECT_EQ(starts(), 0U);
    EXPECT_EQ(controller.statistics().send_failures, 0U);
}

TEST_F(CanControllerTest, ErrorsAreCountedAndCleared) {
    open();
    device.raise(can::event_bits::error);
    device.errors = 0x11U;  // acknowledgement and bit error
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(controller.statistics().error_frames, 1U);
    EXPECT_EQ(device.errors, 0U);
}

TEST_F(CanControllerTest, FollowsTheErrorStateOfTheController) {
    open();
    device.error_state = 3U;
    EXPECT_EQ(controller.state(), BusState::error_passive);
    device.error_state = 2U;
    EXPECT_EQ(controller.state(), BusState::bus_off);
    device.error_state = 1U;
    EXPECT_EQ(controller.state(), BusState::error_active);
    device.error_state = 0U;  // as the emulator leaves it
    EXPECT_EQ(controller.state(), BusState::error_active);
}

TEST_F(CanControllerTest, ABusOffTakesTheControllerOffTheBusAndBackAfterAWhile) {
    open();
    device.raise(can::event_bits::bus_off);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(controller.state(), BusState::bus_off);
    EXPECT_EQ(device.value_of(can::software_reset), 0U);
    EXPECT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::failed);

    pass(99);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(starts(), 0U);
    pass(1);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(starts(), 1U);
    EXPECT_EQ(controller.state(), BusState::error_active);
    EXPECT_EQ(device.value_of(can::filter_enable), 7U);  // as it was opened
    EXPECT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::sent);
}

TEST_F(CanControllerTest, RepeatedBusOffsAreRateLimitedUntilAFrameIsHeard) {
    open();
    for (const std::int64_t interval : {100, 200, 400, 800, 1600, 1600}) {
        device.raise(can::event_bits::bus_off);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::failed);
        pass(interval - 1);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::failed) << interval;
        pass(1);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::empty) << interval;
    }
    device.arrive(words_of(0x120U));
    ASSERT_EQ(controller.receive(frame), ReceiveResult::frame);
    device.raise(can::event_bits::bus_off);
    ASSERT_EQ(controller.receive(frame), ReceiveResult::failed);
    pass(100);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
}

TEST_F(CanControllerTest, NoCallTakesMoreThanABoundedNumberOfAccesses) {
    open();
    for (std::size_t i = 0U; i < can::fifo_depth; ++i) {
        device.arrive({words_of(0x120U)[0], 0U, 0U, 0U});
    }
    device.raise(0x7FFFU & ~can::event_bits::bus_off);
    device.accesses = 0U;
    EXPECT_EQ(controller.receive(frame), ReceiveResult::frame);
    EXPECT_LE(device.accesses, 20U);
    device.accesses = 0U;
    EXPECT_EQ(controller.send(make_frame(0x0D0U, {})), SendResult::sent);
    EXPECT_LE(device.accesses, 6U);
}

class SendLastTest : public CanControllerTest {
 protected:
    static constexpr std::uint32_t polls = 100U;
    bool send_last() {
        return Controller::send_last(FakeRegisters{&device}, make_frame(0x0D0U, {9U}), polls);
    }
};

TEST_F(SendLastTest, SendsOneFrameAndWaitsUntilItHasLeft) {
    open();
    EXPECT_TRUE(send_last());
    ASSERT_EQ(device.sent.size(), 1U);
    EXPECT_EQ(device.sent[0], SiliconCanFrameLayout::pack(make_frame(0x0D0U, {9U})));
}

TEST_F(SendLastTest, GivesUpWhenTheFrameDoesNotLeave) {
    open();
    device.has_bus = false;
    device.accesses = 0U;
    EXPECT_FALSE(send_last());
    EXPECT_LE(device.accesses, polls + 10U);
}

TEST_F(SendLastTest, GivesUpWhenThereIsNoRoom) {
    open();
    device.has_bus = false;
    for (std::size_t i = 0U; i < can::fifo_depth; ++i) {
        ASSERT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::sent);
    }
    device.accesses = 0U;
    EXPECT_FALSE(send_last());
    EXPECT_LE(device.accesses, polls + 10U);
}

TEST_F(SendLastTest, DoesNothingWhenTheControllerIsNotOnTheBus) {
    EXPECT_FALSE(send_last());
    EXPECT_TRUE(device.writes.empty());
}

}  // namespace
}  // namespace hal::zynqmp_r5::testing
