// The CAN driver against a fake of the controller's registers.
#include "hal/zynqmp_r5/can_controller.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "hal/memory/virtual_clock.hpp"
#include "tests/hal/make_frame.hpp"
#include "tests/hal/zynqmp_r5/can_device.hpp"

namespace rsi::hal::zynqmp_r5::testing {
namespace {

using rsi::hal::testing::make_frame;
using Controller = CanController<FakeRegisters, SiliconCanFrameLayout>;

CanSettings three_acceptances() {
    CanSettings settings;
    settings.accepted = {{{0x120U}, {0x121U, 0x7FEU}, {0x122U}}};
    settings.accepted_count = 3U;
    return settings;
}

CanFrameWords words_of(std::uint32_t identifier) {
    return SiliconCanFrameLayout::pack(make_frame(identifier, {1U, 2U, 3U}));
}

class CanControllerTest : public ::testing::Test {
 protected:
    void open() {
        ASSERT_TRUE(controller.open(three_acceptances()));
        pass(1);
        device.writes.clear();
    }
    void pass(std::int64_t milliseconds) {
        clock.set(clock.now() + Time::from_milliseconds(milliseconds));
        device.pass(1'000'000 * milliseconds);
    }
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
    ASSERT_TRUE(controller.open(three_acceptances()));
    constexpr std::uint32_t mask = 0xFFF8'0000U;
    const std::vector<Write> expected{
        {0xFF06'0000U, 1U},            // reset
        {0xFF06'0004U, 0U},            // normal mode
        {0xFF06'0008U, 9U},            // 500 kbit/s
        {0xFF06'000CU, 0x12FU},        //
        {0xFF06'0060U, 0U},            // filters off, while they are set
        {0xFF06'0064U, mask},          //
        {0xFF06'0068U, 0x2400'0000U},  //
        {0xFF06'006CU, 0xFFD8'0000U},  // its last bit may be any
        {0xFF06'0070U, 0x2420'0000U},  //
        {0xFF06'0074U, mask},          //
        {0xFF06'0078U, 0x2440'0000U},  //
        {0xFF06'0060U, 7U},            // three filters on
        {0xFF06'0020U, 0U},            // no interrupts
        {0xFF06'0024U, 0x7FFFU},       // no events
        {0xFF06'0000U, 2U},            // on the bus
    };
    EXPECT_EQ(device.writes, expected);
    EXPECT_EQ(controller.state(), BusState::closed);  // it waits for eleven recessive bits
    pass(1);
    EXPECT_EQ(controller.state(), BusState::error_active);
}

TEST_F(CanControllerTest, WithoutIdentifiersEveryFrameIsLetThrough) {
    ASSERT_TRUE(controller.open());
    pass(1);
    EXPECT_EQ(device.value_of(can::filter_enable), 0U);
    device.arrive(words_of(0x7FFU));
    EXPECT_EQ(controller.receive(frame), ReceiveResult::frame);
}

TEST_F(CanControllerTest, RefusesImpossibleSettingsWithoutTouchingTheController) {
    CanSettings settings = three_acceptances();
    settings.accepted[1].identifier = 0x800U;
    EXPECT_FALSE(controller.open(settings));
    settings = three_acceptances();
    settings.accepted[1].mask = 0x800U;
    EXPECT_FALSE(controller.open(settings));
    settings = three_acceptances();
    settings.accepted_count = 5U;
    EXPECT_FALSE(controller.open(settings));
    EXPECT_EQ(device.accesses, 0U);
    EXPECT_EQ(controller.state(), BusState::closed);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(controller.send(make_frame(0x123U, {})), SendResult::failed);
}

TEST_F(CanControllerTest, TakesAsManyAcceptancesAsThereAreFilters) {
    CanSettings settings = three_acceptances();
    settings.accepted[3].identifier = 0x7FFU;
    settings.accepted_count = 4U;
    EXPECT_TRUE(controller.open(settings));
}

TEST_F(CanControllerTest, BeforeItIsOpenedItDoesNotTouchTheController) {
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(device.accesses, 0U);
}

TEST_F(CanControllerTest, AControllerThatDoesNotRespondCostsABoundedTimeAndIsTriedAgain) {
    device.responds_to_reset = false;
    EXPECT_FALSE(controller.open(three_acceptances()));
    EXPECT_EQ(device.accesses, 1001U) << "one that asks for the reset, and a thousand looks";
    EXPECT_EQ(controller.state(), BusState::closed);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);

    device.responds_to_reset = true;
    pass(99);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);
    pass(1);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    pass(1);
    EXPECT_EQ(controller.state(), BusState::error_active);
}

TEST_F(CanControllerTest, AControllerThatDoesNotRespondIsTriedAtAnEvenPace) {
    device.responds_to_reset = false;
    EXPECT_FALSE(controller.open(three_acceptances()));
    device.writes.clear();
    for (int cycle = 0; cycle < 300; ++cycle) {
        pass(10);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::failed);
    }
    EXPECT_EQ(device.writes, std::vector<Write>(30U, Write{can::software_reset, can::reset_bits::reset}));

    device.responds_to_reset = true;
    pass(100);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
}

// The longer and longer waits are for the sake of the others on the bus, whom a mute controller does not
// disturb.
TEST_F(CanControllerTest, ABusOffAfterAMuteControllerIsWaitedForAsTheFirstOne) {
    device.responds_to_reset = false;
    EXPECT_FALSE(controller.open(three_acceptances()));
    for (int attempt = 0; attempt < 5; ++attempt) {
        pass(100);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::failed);
    }
    device.responds_to_reset = true;
    pass(100);
    ASSERT_EQ(controller.receive(frame), ReceiveResult::empty);
    device.go_bus_off();
    ASSERT_EQ(controller.receive(frame), ReceiveResult::failed);
    pass(100);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
}

TEST_F(CanControllerTest, FiltersThatStayBusyAreNotWaitedForForEver) {
    device.filters_stay_busy = true;
    EXPECT_FALSE(controller.open(three_acceptances()));
    EXPECT_LE(device.accesses, 2U * most_can_polls);
    EXPECT_EQ(starts(), 0U);
}

TEST_F(CanControllerTest, ReceivesWhatTheFiltersLetThroughInItsOrderWithTheTimeOfReceiving) {
    open();
    device.arrive(words_of(0x120U));
    device.arrive(words_of(0x300U));
    device.arrive(words_of(0x122U));
    pass(6);
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
    // Each frame taken is acknowledged to the controller, and nothing else is.
    EXPECT_EQ(device.writes, (std::vector<Write>{{0xFF06'0024U, 1U << 7U}, {0xFF06'0024U, 1U << 7U}}));
}

TEST_F(CanControllerTest, GivesTheTimeAtWhichAFrameWasTakenFromTheController) {
    open();
    device.arrive(words_of(0x120U));
    pass(2);
    controller.take_waiting();
    device.arrive(words_of(0x122U));
    pass(3);
    ASSERT_EQ(controller.receive(frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x120U);
    EXPECT_EQ(frame.receive_time, Time::from_milliseconds(3));
    ASSERT_EQ(controller.receive(frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x122U);
    EXPECT_EQ(frame.receive_time, Time::from_milliseconds(6));
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(controller.statistics().frames_received, 2U);
}

TEST_F(CanControllerTest, LeavesInTheFifoWhatItCannotTake) {
    open();
    for (std::size_t i = 0U; i < can::fifo_depth; ++i) {
        device.arrive(words_of(0x120U));
    }
    controller.take_waiting();
    controller.take_waiting();
    EXPECT_EQ(controller.statistics().frames_received, most_taken);
    std::size_t received = 0U;
    while (controller.receive(frame) == ReceiveResult::frame) {
        ++received;
    }
    EXPECT_EQ(received, can::fifo_depth);
    EXPECT_EQ(controller.statistics().frames_lost, 0U);
}

TEST_F(CanControllerTest, RemoteFramesAreSkipped) {
    ASSERT_TRUE(controller.open());
    pass(1);
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
        {0xFF06'0024U, 1U << 1U},      // forget frames that were sent before
        {0xFF06'0030U, 0x1A00'0000U},  // identifier
        {0xFF06'0034U, 0x5000'0000U},  // length
        {0xFF06'0038U, 0x1122'3344U},  //
        {0xFF06'003CU, 0x5500'0000U},  //
        {0xFF06'0024U, 1U << 14U},     // forget that the FIFO was empty, now that it is not
    };
    EXPECT_EQ(device.writes, expected);
    EXPECT_TRUE(device.sent.empty());
    pass(1);
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
    device.go_bus_off();
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
    pass(1);
    EXPECT_EQ(controller.state(), BusState::error_active);
    EXPECT_EQ(device.value_of(can::filter_enable), 7U);  // as it was opened
    EXPECT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::sent);
}

TEST_F(CanControllerTest, FramesThatWaitWhenTheBusGoesOffAreNotSentAfterIt) {
    open();
    device.has_bus = false;
    ASSERT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::sent);
    device.go_bus_off();
    device.connect();
    device.arrive(words_of(0x120U));
    EXPECT_EQ(controller.receive(frame), ReceiveResult::failed);
    pass(100);
    EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
    pass(1);
    EXPECT_TRUE(device.sent.empty());
    ASSERT_EQ(controller.send(make_frame(0x0D0U, {2U})), SendResult::sent);
    pass(1);
    ASSERT_EQ(device.sent.size(), 1U);
    EXPECT_EQ(device.sent[0][2], 0x0200'0000U);
}

TEST_F(CanControllerTest, RepeatedBusOffsAreRateLimitedUntilAFrameIsHeard) {
    open();
    for (const std::int64_t interval : {100, 200, 400, 800, 1600, 1600}) {
        device.go_bus_off();
        ASSERT_EQ(controller.receive(frame), ReceiveResult::failed);
        pass(interval - 1);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::failed) << interval;
        pass(1);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::empty) << interval;
    }
    pass(1);
    device.arrive(words_of(0x120U));
    ASSERT_EQ(controller.receive(frame), ReceiveResult::frame);
    device.go_bus_off();
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
    EXPECT_LE(device.accesses, 8U);
}

std::string name_of(const ::testing::TestParamInfo<EmptyEvent>& info) {
    constexpr std::array<const char*, 4> names{"Standing", "Level", "OnEmptying", "OnStartOfLast"};
    return names[static_cast<std::size_t>(info.param)];
}

// For each meaning of "transmit FIFO empty".
class SendingTest : public CanControllerTest, public ::testing::WithParamInterface<EmptyEvent> {
 protected:
    void SetUp() override {
        device.empty_event = GetParam();
        open();
    }
    void no_bus_from_now_on() { device.has_bus = false; }
    void send(std::uint8_t first_byte) {
        ASSERT_EQ(controller.send(make_frame(0x0D0U, {first_byte})), SendResult::sent);
    }
    void expect_thrown_away(std::int64_t after_milliseconds) {
        pass(after_milliseconds);
        EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
        EXPECT_EQ(device.waiting_to_leave(), 1U);
        EXPECT_EQ(controller.statistics().send_failures, 0U);
        pass(1);
        EXPECT_EQ(controller.receive(frame), ReceiveResult::empty);
        EXPECT_EQ(device.waiting_to_leave(), 0U);
        EXPECT_EQ(controller.statistics().send_failures, 1U);
    }
};
INSTANTIATE_TEST_SUITE_P(EmptyEvent, SendingTest,
                         ::testing::Values(EmptyEvent::standing, EmptyEvent::level, EmptyEvent::on_emptying,
                                           EmptyEvent::on_start_of_last),
                         name_of);

TEST_P(SendingTest, AFrameThatCannotLeaveIsThrownAwayInsteadOfSentLate) {
    no_bus_from_now_on();
    send(1U);
    expect_thrown_away(50);

    device.connect();
    pass(1);
    EXPECT_TRUE(device.sent.empty());
    send(2U);
    pass(1);
    ASSERT_EQ(device.sent.size(), 1U);
    EXPECT_EQ(device.sent[0][2], 0x0200'0000U);
}

TEST_P(SendingTest, AFrameThatLeftBeforeSaysNothingOfTheNextOne) {
    for (const bool looks_in_between : {false, true}) {
        device.has_bus = true;
        open();
        send(1U);
        pass(1);
        ASSERT_EQ(device.waiting_to_leave(), 0U);
        if (looks_in_between) {
            ASSERT_EQ(controller.receive(frame), ReceiveResult::empty);
        }
        no_bus_from_now_on();
        send(2U);
        expect_thrown_away(50);
    }
}

// With an event that comes when the last frame has left.
class SendingOneAfterAnotherTest : public SendingTest {};
INSTANTIATE_TEST_SUITE_P(EmptyEvent, SendingOneAfterAnotherTest,
                         ::testing::Values(EmptyEvent::standing, EmptyEvent::level, EmptyEvent::on_emptying),
                         name_of);

// At every moment around its end the first frame may leave.
TEST_P(SendingOneAfterAnotherTest, OfTwoFramesTheFirstSaysNothingOfTheSecond) {
    for (std::int64_t accesses = 0; accesses < 20; ++accesses) {
        device.has_bus = true;
        device.bus_dies_after = 1U;
        open();
        send(1U);
        device.pass(device.frame_ns - CanDevice::access_ns * accesses);
        send(2U);
        expect_thrown_away(50);
    }
}

// If the event says that the last frame begins, it cannot be distinguished from one that has left; the next
// frame can.
TEST_P(SendingTest, AStuckSecondFrameIsThrownAwayWithTheNextOne) {
    device.bus_dies_after = 1U;
    send(1U);
    send(2U);
    for (int cycle = 0; cycle < 7 && starts() == 0U; ++cycle) {
        pass(10);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::empty);
        static_cast<void>(controller.send(make_frame(0x0D0U, {3U})));
    }
    EXPECT_EQ(starts(), 1U);
    EXPECT_EQ(device.sent.size(), 1U);
}

TEST_P(SendingTest, FramesThatLeaveInTimeAreNotThrownAway) {
    for (std::uint8_t cycle = 0U; cycle < 20U; ++cycle) {
        for (std::uint8_t i = 0U; i < 6U; ++i) {
            send(i);
        }
        pass(10);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::empty);
    }
    pass(100);
    ASSERT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(starts(), 0U);
    EXPECT_EQ(controller.statistics().send_failures, 0U);
    EXPECT_EQ(device.sent.size(), 120U);
}

TEST_P(SendingTest, ASingleFrameThatLeavesBeforeTheProcessorGoesOnIsNotThrownAway) {
    device.frame_ns = 0;
    send(1U);
    pass(100);
    ASSERT_EQ(controller.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(starts(), 0U);
}

// Under the emulator a frame has left when the write of its last word ends; the event stands there.
TEST_F(CanControllerTest, FramesThatTakeNoTimeAreNotThrownAwayWhereTheEmptyEventStands) {
    for (const EmptyEvent meaning : {EmptyEvent::standing, EmptyEvent::level}) {
        device.empty_event = meaning;
        device.frame_ns = 0;
        open();
        for (int i = 0; i < 6; ++i) {
            ASSERT_EQ(controller.send(make_frame(0x0D0U, {1U})), SendResult::sent);
        }
        pass(100);
        ASSERT_EQ(controller.receive(frame), ReceiveResult::empty);
        EXPECT_EQ(starts(), 0U);
        EXPECT_TRUE(Controller::send_last(FakeRegisters{&device}, make_frame(0x0D0U, {9U}), 10U));
    }
}

class SendLastTest : public SendingTest {
 protected:
    static constexpr std::uint32_t polls = 20'000U;  // of a tenth of a microsecond: nine frames
    bool send_last() {
        device.accesses = 0U;
        return Controller::send_last(FakeRegisters{&device}, make_frame(0x0D0U, {9U}), polls);
    }
};
INSTANTIATE_TEST_SUITE_P(EmptyEvent, SendLastTest,
                         ::testing::Values(EmptyEvent::standing, EmptyEvent::level, EmptyEvent::on_emptying),
                         name_of);

// The reset that follows would cut it off.
TEST_P(SendLastTest, SendsOneFrameAndWaitsUntilItHasLeft) {
    EXPECT_TRUE(send_last());
    ASSERT_EQ(device.sent.size(), 1U);
    EXPECT_EQ(device.sent[0], SiliconCanFrameLayout::pack(make_frame(0x0D0U, {9U})));
    EXPECT_LE(device.accesses, 222'000U / 100U + 10U);
}

TEST_P(SendLastTest, AFrameThatLeftBeforeSaysNothingOfTheLastOne) {
    send(1U);
    pass(1);
    EXPECT_TRUE(send_last());
    EXPECT_EQ(device.sent.size(), 2U);
}

TEST_P(SendLastTest, WaitsForTheFramesBeforeItToo) {
    for (std::uint8_t i = 0U; i < 6U; ++i) {
        send(i);
    }
    EXPECT_TRUE(send_last());
    EXPECT_EQ(device.sent.size(), 7U);
}

TEST_P(SendLastTest, AFrameThatLeavesMeanwhileIsNotTakenForIt) {
    for (std::int64_t accesses = 0; accesses < 20; ++accesses) {
        open();
        device.sent.clear();
        send(1U);
        device.pass(device.frame_ns - CanDevice::access_ns * accesses);
        EXPECT_TRUE(send_last());
        EXPECT_EQ(device.sent.size(), 2U) << accesses;
    }
}

TEST_P(SendLastTest, GivesUpWhenTheFrameDoesNotLeave) {
    no_bus_from_now_on();
    EXPECT_FALSE(send_last());
    EXPECT_LE(device.accesses, polls + 10U);
}

TEST_P(SendLastTest, GivesUpAtABusOff) {
    device.go_bus_off();
    EXPECT_FALSE(send_last());
    EXPECT_LE(device.accesses, polls + 10U);
    EXPECT_TRUE(device.sent.empty());
}

TEST_P(SendLastTest, GivesUpWhenThereIsNoRoom) {
    no_bus_from_now_on();
    for (std::size_t i = 0U; i < can::fifo_depth; ++i) {
        send(1U);
    }
    EXPECT_FALSE(send_last());
    EXPECT_LE(device.accesses, polls + 10U);
}

// If the event only says that the frame begins to be sent, it has come before it is waited for: too long a
// wait, but the frame is not cut off.
TEST_F(CanControllerTest, TheLastFrameLeavesEvenIfTheEmptyEventSaysThatItBegins) {
    device.empty_event = EmptyEvent::on_start_of_last;
    open();
    device.accesses = 0U;
    EXPECT_FALSE(Controller::send_last(FakeRegisters{&device}, make_frame(0x0D0U, {9U}), 20'000U));
    EXPECT_LE(device.accesses, 20'010U);
    EXPECT_EQ(device.sent.size(), 1U);
}

TEST_F(CanControllerTest, TheLastFrameIsNotTriedWhenTheControllerIsNotOnTheBus) {
    EXPECT_FALSE(Controller::send_last(FakeRegisters{&device}, make_frame(0x0D0U, {9U}), 100U));
    EXPECT_TRUE(device.writes.empty());
}

}  // namespace
}  // namespace rsi::hal::zynqmp_r5::testing
