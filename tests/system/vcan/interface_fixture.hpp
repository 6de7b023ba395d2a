// The virtual CAN interface of these tests, and what the tests do to it.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "hal/linux/steady_clock.hpp"
#include "hal/socketcan/socket_can_bus.hpp"

namespace rsi::hal::testing {

// From the environment variable RSI_CAN_INTERFACE; vcan0 when it is not set.
std::string interface_name();

// These need the right to configure interfaces, as root of a network namespace or of a virtual machine has
// it. They end the test program with a message when refused, for nothing after them would mean anything.
void set_interface_up(bool up);
void set_interface_mtu(int bytes);  // sets the interface down for a moment

// Puts a frame on the bus with no help of the code under test; `can_id` with the kernel's flags.
void send_raw(std::uint32_t can_id, std::uint8_t second_byte = 0U);

// Two open buses on the interface, which is up and takes CAN FD frames before and after each test.
class InterfaceTest : public ::testing::Test {
 protected:
    void SetUp() override;
    void TearDown() override;

    // Opens with the test's interface, or ends in a failure that shows the message.
    static void open_or_fail(SocketCanBus& bus, SocketCanSettings settings = {});

    // A process that takes so long hangs, however busy the machine is.
    static constexpr Time longest_wait = Time::from_milliseconds(60'000);

    // Waits for the next frame; the kernel may hand it over a moment after it was sent.
    static ReceiveResult receive_soon(SocketCanBus& bus, CanFrame& frame);

    SteadyClock clock;
    SocketCanBus first;
    SocketCanBus second;
    CanFrame frame;
};

}  // namespace rsi::hal::testing
