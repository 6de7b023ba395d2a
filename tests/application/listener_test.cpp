// Others on the same bus: the frames that they receive; and an ECU in silent mode.
#include <gtest/gtest.h>

#include <vector>

#include "rsi/hal/frame_listener.hpp"
#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

class Listener final : public rsi::hal::FrameListener {
 public:
    void take(const rsi::hal::CanFrame& frame) noexcept override { heard.push_back(frame.identifier); }
    std::vector<std::uint32_t> heard{};
};

class Listeners : public ::testing::Test {
 protected:
    void send(std::uint32_t identifier, bool is_extended = false) {
        rsi::hal::CanFrame frame{};
        frame.identifier = identifier;
        frame.extended = is_extended;
        frame.length = 8U;
        bus_.endpoint(1U).send(frame);
    }
    std::size_t frames_sent() {
        std::size_t count = 0U;
        rsi::hal::CanFrame frame{};
        while (bus_.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            ++count;
        }
        return count;
    }

    rsi::hal::VirtualClock clock_;
    rsi::hal::MemoryBus<2U> bus_{clock_};
    NoWatchdog watchdog_;
    rsi::application::RolloverEcu ecu_{bus_.endpoint(0U), clock_, watchdog_};
};

TEST_F(Listeners, HearWhatIsNoSensorsInTheOrderOfTheBus) {
    Listener one;
    Listener other;
    ASSERT_TRUE(ecu_.add_listener(one));
    ASSERT_TRUE(ecu_.add_listener(other));
    send(0x7A6U);
    send(rsi::can_dbc::Imu::identifier);
    send(0x123U, true);
    send(0x6F0U);
    ecu_.step(0U);
    const std::vector<std::uint32_t> foreign{0x7A6U, 0x6F0U};
    EXPECT_EQ(one.heard, foreign);
    EXPECT_EQ(other.heard, foreign);
}

TEST_F(Listeners, AreTwoAtMost) {
    Listener listeners[3];
    EXPECT_TRUE(ecu_.add_listener(listeners[0]));
    EXPECT_TRUE(ecu_.add_listener(listeners[1]));
    EXPECT_FALSE(ecu_.add_listener(listeners[2]));
    send(0x7A6U);
    ecu_.step(0U);
    EXPECT_EQ(listeners[1].heard.size(), 1U);
    EXPECT_TRUE(listeners[2].heard.empty());
}

TEST_F(Listeners, AnEcuThatIsNotToSendIsSilentWithoutAFault) {
    ecu_.init(large_suv());
    ecu_.set_sending(false);
    ecu_.step(0U);
    EXPECT_EQ(frames_sent(), 0U);
    EXPECT_FALSE(ecu_.diagnostic_memory().active(rsi::monitoring::DiagnosticCode::bus_error));
    ecu_.set_sending(true);
    ecu_.step(0U);
    EXPECT_EQ(frames_sent(), frames_per_cycle);
}

}  // namespace
}  // namespace testing_application
