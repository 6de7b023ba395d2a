// SocketCanBus when the controller reports errors, and when the interface is missing, goes down or comes
// back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can.h>
#include <linux/can/error.h>

#include <algorithm>
#include <cstdlib>

#include "tests/hal/make_frame.hpp"
#include "tests/system/vcan/interface_fixture.hpp"

namespace rsi::hal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::interface_name;
using testing::make_frame;
using testing::send_raw;
using testing::set_interface_up;

class BusStateTest : public testing::InterfaceTest {
 protected:
    // Waits for what has been sent, reads it, and returns the bus's state.
    BusState state_after_reading(SocketCanBus& bus) {
        bus.wait_for_frame(longest_wait);
        bus.receive(frame);
        return bus.state();
    }

    // The bus looks for its interface every 100 ms; waits for that at most two seconds.
    bool recovers(SocketCanBus& bus) {
        for (int i = 0; i < 200 && bus.state() == BusState::closed; ++i) {
            clock.wait_until(clock.now() + Time::from_milliseconds(10));
            bus.receive(frame);
        }
        return bus.state() == BusState::error_active;
    }
};

TEST_F(BusStateTest, ErrorFramesMoveTheStateAndAreNotReceivedAsFrames) {
    send_raw(CAN_ERR_FLAG | CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE);
    EXPECT_EQ(state_after_reading(first), BusState::error_passive);
    send_raw(CAN_ERR_FLAG | CAN_ERR_BUSOFF);
    EXPECT_EQ(state_after_reading(first), BusState::bus_off);
    EXPECT_EQ(first.send(make_frame(1U)), SendResult::failed);
    send_raw(CAN_ERR_FLAG | CAN_ERR_RESTARTED);
    EXPECT_EQ(state_after_reading(first), BusState::error_active);
    EXPECT_EQ(first.send(make_frame(1U)), SendResult::sent);
    EXPECT_EQ(first.statistics().error_frames, 3U);
    EXPECT_EQ(first.statistics().frames_received, 0U);
}

TEST_F(BusStateTest, AFrameBehindAnErrorFrameIsReceivedInTheSameCall) {
    send_raw(CAN_ERR_FLAG | CAN_ERR_CRTL, CAN_ERR_CRTL_RX_PASSIVE);
    send_raw(0x77U);
    send_raw(0x78U);
    ASSERT_EQ(receive_soon(first, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x77U);
    EXPECT_EQ(first.state(), BusState::error_passive);
}

TEST_F(BusStateTest, AReceivedFrameEndsBusOff) {
    send_raw(CAN_ERR_FLAG | CAN_ERR_BUSOFF);
    ASSERT_EQ(state_after_reading(first), BusState::bus_off);
    send_raw(0x77U);
    ASSERT_EQ(receive_soon(first, frame), ReceiveResult::frame);
    EXPECT_EQ(first.state(), BusState::error_active);
}

TEST_F(BusStateTest, AFloodOfErrorFramesDoesNotHoldUpTheCaller) {
    for (int i = 0; i < 200; ++i) {
        send_raw(CAN_ERR_FLAG | CAN_ERR_PROT);
    }
    send_raw(0x77U);
    send_raw(0x78U);
    // Until the second bus has received the last one: then all are there, however busy the machine is.
    while (frame.identifier != 0x78U) {
        ASSERT_TRUE(second.wait_for_frame(longest_wait));
        second.receive(frame);
    }
    int calls = 1;
    while (first.receive(frame) != ReceiveResult::frame && calls < 100) {
        ++calls;
    }
    EXPECT_EQ(frame.identifier, 0x77U);
    EXPECT_EQ(calls, 4);  // 64 error frames a call
    EXPECT_EQ(first.statistics().error_frames, 200U);
}

TEST_F(BusStateTest, AnInterfaceThatGoesDownClosesTheBusUntilItIsUpAgain) {
    set_interface_up(false);
    EXPECT_EQ(first.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(first.state(), BusState::closed);
    EXPECT_EQ(first.send(make_frame(1U)), SendResult::failed);
    EXPECT_EQ(first.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(first.state(), BusState::closed);

    set_interface_up(true);
    ASSERT_TRUE(recovers(first));
    ASSERT_TRUE((second.receive(frame), recovers(second)));
    ASSERT_EQ(first.send(make_frame(0x33U)), SendResult::sent);
    ASSERT_EQ(receive_soon(second, frame), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x33U);
}

TEST_F(BusStateTest, ASenderNoticesThatTheInterfaceIsDown) {
    set_interface_up(false);
    EXPECT_EQ(first.send(make_frame(1U)), SendResult::failed);
    EXPECT_EQ(first.state(), BusState::closed);
    EXPECT_EQ(first.statistics().send_failures, 1U);
    EXPECT_EQ(first.statistics().frames_sent, 0U);
}

TEST_F(BusStateTest, FramesWaitingFromBeforeAreStillReadAfterwards) {
    second.send(make_frame(0x11U));
    ASSERT_TRUE(first.wait_for_frame(longest_wait));
    set_interface_up(false);
    EXPECT_EQ(first.receive(frame), ReceiveResult::failed);
    set_interface_up(true);
    for (int i = 0; i < 200 && first.receive(frame) != ReceiveResult::frame; ++i) {
        clock.wait_until(clock.now() + Time::from_milliseconds(10));
    }
    EXPECT_EQ(frame.identifier, 0x11U);
}

TEST_F(BusStateTest, BusOffIsEndedByARestartAfterTheTimeOfTheSchedule) {
    SocketCanSettings settings;
    settings.restart_when_bus_off = true;
    open_or_fail(first, settings);
    for (const int wait_ms : {100, 200}) {
        const Time before = clock.now();
        send_raw(CAN_ERR_FLAG | CAN_ERR_BUSOFF);
        ASSERT_EQ(state_after_reading(first), BusState::bus_off);
        EXPECT_EQ(first.send(make_frame(1U)), SendResult::failed);
        for (int i = 0; i < 400 && first.state() != BusState::error_active; ++i) {
            clock.wait_until(clock.now() + Time::from_milliseconds(5));
            first.receive(frame);
        }
        EXPECT_EQ(first.state(), BusState::error_active);
        EXPECT_FALSE(clock.now() - before < Time::from_milliseconds(wait_ms));
    }
    EXPECT_EQ(first.bus_off_report().times, 2U);
    EXPECT_EQ(first.bus_off_report().restarts, 2U);
    EXPECT_EQ(first.bus_off_report().refusal, 0);
    EXPECT_EQ(first.send(make_frame(1U)), SendResult::sent);
}

TEST_F(BusStateTest, BusOffIsLeftToTheKernelWithoutARequestToRestart) {
    send_raw(CAN_ERR_FLAG | CAN_ERR_BUSOFF);
    ASSERT_EQ(state_after_reading(first), BusState::bus_off);
    clock.wait_until(clock.now() + BusOffSchedule::shortest + BusOffSchedule::shortest);
    EXPECT_EQ(first.receive(frame), ReceiveResult::empty);
    EXPECT_EQ(first.state(), BusState::bus_off);
    EXPECT_EQ(first.bus_off_report().times, 1U);
    EXPECT_EQ(first.bus_off_report().restarts, 0U);
}

// An interface of its own, as a CAN adapter that can be unplugged.
class UnpluggedInterfaceTest : public testing::InterfaceTest {
 protected:
    static void plug_in() {
        ASSERT_EQ(std::system("ip link add dev unplug0 type vcan && ip link set unplug0 up"), 0);
    }
    static void unplug() { ASSERT_EQ(std::system("ip link delete unplug0"), 0); }
    void SetUp() override { plug_in(); }
    void TearDown() override { static_cast<void>(std::system("ip link delete unplug0 2>/dev/null")); }

    ReceiveResult receive_within_two_seconds(SocketCanBus& bus, SocketCanBus& sender) {
        ReceiveResult result = ReceiveResult::empty;
        for (int i = 0; i < 200 && result != ReceiveResult::frame; ++i) {
            sender.send(make_frame(0x101U));
            sender.send(make_frame(0x100U));
            clock.wait_until(clock.now() + Time::from_milliseconds(10));
            result = bus.receive(frame);
        }
        return result;
    }
};

TEST_F(UnpluggedInterfaceTest, ComesBackWithItsFiltersWhenPluggedInAgain) {
    const CanIdentifier wanted{0x100U, false};
    SocketCanSettings settings;
    settings.interface_name = "unplug0";
    ASSERT_TRUE(static_cast<bool>(second.open(settings)));
    settings.identifiers = &wanted;
    settings.identifier_count = 1U;
    ASSERT_TRUE(static_cast<bool>(first.open(settings)));

    unplug();
    EXPECT_EQ(first.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(second.send(make_frame(1U)), SendResult::failed);
    EXPECT_EQ(first.state(), BusState::closed);
    EXPECT_EQ(second.state(), BusState::closed);

    plug_in();
    ASSERT_EQ(receive_within_two_seconds(first, second), ReceiveResult::frame);
    EXPECT_EQ(frame.identifier, 0x100U);
    EXPECT_EQ(first.state(), BusState::error_active);
    EXPECT_EQ(second.state(), BusState::error_active);
}

TEST_F(UnpluggedInterfaceTest, DoesNotStallTheCallerWhileItIsGone) {
    SocketCanSettings settings;
    settings.interface_name = "unplug0";
    ASSERT_TRUE(static_cast<bool>(first.open(settings)));
    unplug();
    EXPECT_EQ(first.receive(frame), ReceiveResult::failed);
    Time shortest = Time::from_milliseconds(1000);  // a busy machine may hold up single calls
    for (int i = 0; i < 4; ++i) {
        clock.wait_until(clock.now() + Time::from_milliseconds(110));  // so that each call looks for it anew
        const Time before = clock.now();
        EXPECT_EQ(first.receive(frame), ReceiveResult::failed);
        shortest = std::min(shortest, clock.now() - before);
    }
    EXPECT_LT(shortest, Time::from_milliseconds(90));  // modprobe would cost up to a second each time
}

TEST_F(BusStateTest, OpeningAnInterfaceThatIsDownSaysSo) {
    set_interface_up(false);
    const std::string name = interface_name();
    SocketCanSettings settings;
    settings.interface_name = name.c_str();
    SocketCanBus bus;
    const OpenResult result = bus.open(settings);
    EXPECT_EQ(result.failure, OpenFailure::interface_down);
    EXPECT_THAT(result.message(), AllOf(HasSubstr("'" + name + "'"), HasSubstr("is down"),
                                        HasSubstr("ip link set " + name + " up")));
    EXPECT_EQ(bus.state(), BusState::closed);
}

TEST_F(BusStateTest, OpeningAMissingInterfaceSaysHowToMakeOne) {
    SocketCanSettings settings;
    settings.interface_name = "nosuchcan";
    SocketCanBus bus;
    const OpenResult result = bus.open(settings);
    EXPECT_EQ(result.failure, OpenFailure::interface_missing);
    EXPECT_THAT(result.message(),
                AllOf(HasSubstr("'nosuchcan'"),
                      HasSubstr("ip link add dev nosuchcan type vcan && ip link set nosuchcan up"),
                      HasSubstr("ip link set nosuchcan up type can bitrate 500000")));
}

TEST_F(BusStateTest, OpeningAnInterfaceOfAnotherKindSaysSo) {
    SocketCanSettings settings;
    settings.interface_name = "lo";
    SocketCanBus bus;
    const OpenResult result = bus.open(settings);
    EXPECT_EQ(result.failure, OpenFailure::interface_not_can);
    EXPECT_THAT(result.message(), HasSubstr("not a CAN interface"));
}

TEST_F(BusStateTest, ABusCanBeOpenedAgainAndCountsFromZero) {
    first.send(make_frame(1U));
    ASSERT_EQ(first.statistics().frames_sent, 1U);
    open_or_fail(first);
    EXPECT_EQ(first.statistics().frames_sent, 0U);
    first.close();
    EXPECT_EQ(first.state(), BusState::closed);
    EXPECT_EQ(first.send(make_frame(1U)), SendResult::failed);
}

}  // namespace
}  // namespace rsi::hal
