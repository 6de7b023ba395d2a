// The warning frame that a fault sends: receivers accept its counter, whenever the fault comes.
#include "images/zynqmp_r5/warning_recorder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace rsi::image {
namespace {

using rsi::can_dbc::RolloverWarning;
using Receiver = rsi::can_dbc::e2e::Profile11Receiver;

rsi::hal::CanFrame warning(std::uint8_t counter) {
    auto payload = rsi::can_dbc::encode(RolloverWarning{});
    rsi::can_dbc::e2e::protect_profile_11(payload, RolloverWarning::e2e_data_id, counter);
    rsi::hal::CanFrame frame{};
    frame.identifier = RolloverWarning::identifier;
    frame.length = RolloverWarning::length;
    std::copy(payload.begin(), payload.end(), frame.data.begin());
    return frame;
}

// Delivers what it takes, and lets a fault come in front of that or behind.
class Bus final : public rsi::hal::CanBus {
 public:
    Receiver receiver{RolloverWarning::e2e_data_id, RolloverWarning::length, 3U};
    rsi::hal::SendResult result{rsi::hal::SendResult::sent};
    std::function<void()> before{[] {}};
    std::function<void()> after{[] {}};

    bool deliver(const rsi::hal::CanFrame& frame) {
        return rsi::can_dbc::e2e::is_usable(receiver.check(frame.data, frame.length).status);
    }
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame&) noexcept override {
        return rsi::hal::ReceiveResult::empty;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        before();
        if (result == rsi::hal::SendResult::sent) {
            EXPECT_TRUE(deliver(frame));
        }
        after();
        return result;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }
};

class WarningRecorderTest : public ::testing::Test {
 protected:
    bool fault_is_heard() {
        Receiver as_it_is = bus.receiver;
        const bool is_heard = bus.deliver(warning(last.next_counter()));
        bus.receiver = as_it_is;
        return is_heard;
    }
    void send_cycles(std::uint8_t count) {
        for (std::uint8_t cycle = 0U; cycle < count; ++cycle) {
            ASSERT_EQ(recorder.send(warning(counter)), bus.result);
            counter = static_cast<std::uint8_t>((counter + 1U) % 15U);
        }
    }

    Bus bus;
    LastWarning last;
    WarningRecorder recorder{bus, last};
    std::uint8_t counter{0U};
};

TEST_F(WarningRecorderTest, BeforeTheFirstFrameTheCounterIsZero) {
    EXPECT_EQ(last.next_counter(), 0U);
}

TEST_F(WarningRecorderTest, BetweenTwoFramesTheNextCounterIsUsed) {
    for (std::uint8_t cycle = 0U; cycle < 20U; ++cycle) {
        send_cycles(1U);
        EXPECT_EQ(last.next_counter(), counter);
        EXPECT_TRUE(fault_is_heard());
    }
}

TEST_F(WarningRecorderTest, AFaultWithinASendIsHeardWhetherTheFrameWasTakenOrNot) {
    send_cycles(5U);
    int faults = 0;
    bus.before = bus.after = [&] {
        EXPECT_TRUE(fault_is_heard());
        ++faults;
    };
    send_cycles(20U);
    EXPECT_EQ(faults, 40);
}

TEST_F(WarningRecorderTest, FramesThatWereNotTakenDoNotCount) {
    send_cycles(5U);
    bus.result = rsi::hal::SendResult::full;
    send_cycles(8U);
    EXPECT_EQ(last.next_counter(), 5U);
    EXPECT_TRUE(fault_is_heard());
}

TEST_F(WarningRecorderTest, OtherFramesDoNotCount) {
    send_cycles(5U);
    rsi::hal::CanFrame other = warning(11U);
    other.identifier = rsi::can_dbc::RolloverStatus::identifier;
    bus.before = [this] { EXPECT_EQ(last.counter(), 4U); };
    bus.result = rsi::hal::SendResult::failed;
    recorder.send(other);
    EXPECT_EQ(last.next_counter(), 5U);
}

}  // namespace
}  // namespace rsi::image
