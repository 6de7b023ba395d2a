// ISO-TP: what is on its way is whole or is nothing, times end, and others' frames do not disturb.
#include "rsi/ecu/diagnosis/iso_tp.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "tests/diagnosis/tester.hpp"

namespace testing_diagnosis {
namespace {

using rsi::diagnosis::IsoTp;
using rsi::diagnosis::Request;

Bytes counted(std::size_t length) {
    Bytes bytes(length);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{1U});
    return bytes;
}

// A bus that takes so many frames in a cycle.
class NarrowBus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame&) noexcept override {
        return rsi::hal::ReceiveResult::empty;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        if (room == 0) {
            return rsi::hal::SendResult::full;
        }
        --room;
        sent.push_back(frame);
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }

    int room{1000};
    std::vector<rsi::hal::CanFrame> sent{};
};

class Transport : public ::testing::Test {
 protected:
    void take(const Bytes& payload, std::uint32_t identifier = Tester::physical) {
        rsi::hal::CanFrame frame{};
        frame.identifier = identifier;
        frame.length = static_cast<std::uint8_t>(payload.size());
        std::copy(payload.begin(), payload.end(), frame.data.begin());
        transport_.take(frame);
    }
    void take_consecutive(const Bytes& message, std::size_t from_frame = 1U, std::size_t to_frame = 1000U) {
        for (std::size_t number = from_frame; number <= to_frame; ++number) {
            const std::size_t at = 6U + 7U * (number - 1U);
            if (at >= message.size()) {
                return;
            }
            const std::size_t end = std::min(at + 7U, message.size());
            take(Bytes{static_cast<std::uint8_t>(0x20U | (number & 0x0FU))} +
                 Bytes(message.begin() + static_cast<std::ptrdiff_t>(at),
                       message.begin() + static_cast<std::ptrdiff_t>(end)));
        }
    }
    void take_first(const Bytes& message) {
        take(Bytes{static_cast<std::uint8_t>(0x10U | (message.size() >> 8U)),
                   static_cast<std::uint8_t>(message.size() & 0xFFU)} +
             Bytes(message.begin(), message.begin() + 6));
    }
    Bytes waiting() const {
        const Request request = transport_.request();
        Bytes bytes;
        for (std::size_t place = 0U; place < request.length(); ++place) {
            bytes.push_back(request.byte(place));
        }
        return bytes;
    }
    void send(const Bytes& message) { send(message, message.size()); }
    void send(const Bytes& message, std::size_t length) {
        response_.begin(message[0]);
        for (std::size_t place = 1U; place < length; ++place) {
            response_.put(message[place]);
        }
        transport_.send(response_);
    }
    void cycles(int count) {
        for (int turn = 0; turn < count; ++turn) {
            transport_.end_cycle();
        }
    }
    Bytes last() const {
        return {bus_.sent.back().data.begin(), bus_.sent.back().data.begin() + bus_.sent.back().length};
    }
    // Frames sent in each of the next cycles.
    std::vector<std::size_t> rhythm(int count) {
        std::vector<std::size_t> frames;
        for (int turn = 0; turn < count; ++turn) {
            const std::size_t before = bus_.sent.size();
            transport_.end_cycle();
            frames.push_back(bus_.sent.size() - before);
        }
        return frames;
    }

    NarrowBus bus_{};
    IsoTp transport_{bus_, {}};
    rsi::diagnosis::Response response_{};
    const Bytes continue_to_send_{0x30U, 0U, 0U, 0xCCU, 0xCCU, 0xCCU, 0xCCU, 0xCCU};
    const Bytes overflow_{0x32U, 0U, 0U, 0xCCU, 0xCCU, 0xCCU, 0xCCU, 0xCCU};
};

TEST_F(Transport, TakesASingleFrameOfEveryLengthPaddedOrNot) {
    for (std::size_t length = 1U; length <= 7U; ++length) {
        for (const std::size_t frame : {length + 1U, std::size_t{8U}}) {
            Bytes payload = Bytes{static_cast<std::uint8_t>(length)} + counted(length);
            payload.resize(frame, 0xAAU);
            take(payload);
            EXPECT_EQ(waiting(), counted(length));
            EXPECT_FALSE(transport_.request().is_functional());
            transport_.finish(transport_.request());
            EXPECT_TRUE(waiting().empty());
        }
    }
}

TEST_F(Transport, TakesNoSingleFrameWithoutLengthOrCutOff) {
    for (const std::uint32_t identifier : {Tester::physical, Tester::functional}) {
        take({0x00U, 1U, 2U, 3U}, identifier);
        take({0x04U, 1U, 2U, 3U}, identifier);
        take({0x08U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}, identifier);
        take({}, identifier);
        EXPECT_TRUE(waiting().empty());
        take({0x02U, 0x3EU, 0x00U}, identifier);
        EXPECT_EQ(waiting(), (Bytes{0x3EU, 0x00U})) << "a good one is not kept out by them";
        transport_.finish(transport_.request());
    }
}

// A caller that runs its cycles only while it is active must not lose anything.
TEST_F(Transport, IsActiveWhileAnythingWaitsOrIsOnItsWay) {
    EXPECT_FALSE(transport_.is_active());
    take({0x02U, 0x3EU, 0x00U}, 0x120U);
    EXPECT_FALSE(transport_.is_active()) << "not its own";
    for (const std::uint32_t identifier : {Tester::physical, Tester::functional}) {
        take({0x02U, 0x3EU, 0x00U}, identifier);
        EXPECT_TRUE(transport_.is_active());
        cycles(1);
        EXPECT_TRUE(transport_.is_active()) << "the request waits";
        transport_.finish(transport_.request());
        cycles(1);
        EXPECT_FALSE(transport_.is_active());
    }
    take_first(counted(20U));
    cycles(50);
    EXPECT_TRUE(transport_.is_active()) << "the rest of the request is waited for";
    cycles(50);
    EXPECT_FALSE(transport_.is_active()) << "it is not any more";
    bus_.room = 0;
    take_first(counted(IsoTp::longest_request + 1U));
    cycles(1);
    EXPECT_TRUE(transport_.is_active()) << "the sender has no answer that it is too long";
    bus_.room = 1;
    cycles(1);
    EXPECT_FALSE(transport_.is_active());
    bus_.room = 1;
    send(counted(9U));
    EXPECT_TRUE(transport_.is_active());
    cycles(1);
    EXPECT_TRUE(transport_.is_active()) << "flow control is waited for";
    bus_.room = 1;
    take({0x30U, 0U, 0U});
    cycles(1);
    EXPECT_FALSE(transport_.is_active());
}

TEST_F(Transport, LeavesOthersFramesAlone) {
    rsi::hal::CanFrame frame{};
    frame.length = 2U;
    frame.data[0] = 1U;
    for (const std::uint32_t identifier : {0U, 0x120U, Tester::response, Tester::physical + 1U, 0x7FFU}) {
        frame.identifier = identifier;
        transport_.take(frame);
    }
    frame.identifier = Tester::physical;
    frame.extended = true;
    transport_.take(frame);
    frame.extended = false;
    frame.flexible_data_rate = true;
    transport_.take(frame);
    frame.flexible_data_rate = false;
    frame.length = 9U;
    transport_.take(frame);
    EXPECT_TRUE(waiting().empty());
}

// The bytes of such a frame are those that the driver had left there.
TEST_F(Transport, AFrameWithoutAByteSaysNothing) {
    const Bytes message = counted(20U);
    take_first(message);
    rsi::hal::CanFrame frame{};
    frame.identifier = Tester::physical;
    frame.data[0] = 0x22U;
    transport_.take(frame);
    take_consecutive(message);
    EXPECT_EQ(waiting(), message);
}

TEST_F(Transport, PutsASegmentedRequestTogether) {
    for (const std::size_t length :
         {std::size_t{8U}, std::size_t{13U}, std::size_t{14U}, std::size_t{120U}, IsoTp::longest_request}) {
        const Bytes message = counted(length);
        take_first(message);
        EXPECT_TRUE(transport_.is_receiving());
        cycles(1);
        EXPECT_EQ(last(), continue_to_send_);
        EXPECT_EQ(bus_.sent.back().identifier, Tester::response);
        EXPECT_TRUE(waiting().empty());
        take_consecutive(message);
        EXPECT_EQ(waiting(), message) << length;
        EXPECT_FALSE(transport_.is_receiving());
        transport_.finish(transport_.request());
    }
}

TEST_F(Transport, RefusesAMessageThatIsTooLong) {
    take_first(counted(IsoTp::longest_request + 1U));
    cycles(1);
    EXPECT_EQ(last(), overflow_);
    take({0x10U, 0x00U, 0x00U, 0x01U, 0x00U, 0x00U, 1U, 2U});  // 65536 bytes, as the escape says
    cycles(1);
    EXPECT_EQ(last(), overflow_);
    EXPECT_EQ(bus_.sent.size(), 2U);
    take({0x11U, 0x00U, 1U, 2U, 3U, 4U, 5U, 6U});  // 256 bytes
    cycles(1);
    EXPECT_EQ(last(), overflow_);
    EXPECT_EQ(bus_.sent.size(), 3U);
    take({0x11U, 0x14U, 1U, 2U, 3U, 4U, 5U, 6U});  // 276 bytes
    cycles(1);
    EXPECT_EQ(last(), overflow_);
    EXPECT_EQ(bus_.sent.size(), 4U);
    EXPECT_FALSE(transport_.is_receiving());
    take_consecutive(counted(20U));
    EXPECT_TRUE(waiting().empty());
}

TEST_F(Transport, TakesNoFirstFrameThatNeedsNone) {
    take({0x10U, 7U, 1U, 2U, 3U, 4U, 5U, 6U});
    take({0x10U, 20U, 1U, 2U, 3U, 4U, 5U});  // cut off
    cycles(1);
    EXPECT_TRUE(bus_.sent.empty());
    EXPECT_FALSE(transport_.is_receiving());
}

TEST_F(Transport, AMissingARepeatedOrACutOffFrameEndsTheMessage) {
    const Bytes message = counted(30U);
    take_first(message);
    take_consecutive(message, 2U);
    EXPECT_FALSE(transport_.is_receiving());
    take_consecutive(message, 1U);
    EXPECT_TRUE(waiting().empty());

    take_first(message);
    take_consecutive(message, 1U, 1U);
    take_consecutive(message, 1U);
    EXPECT_TRUE(waiting().empty());

    take_first(message);
    take({0x21U, 7U, 8U, 9U, 10U, 11U, 12U});
    EXPECT_FALSE(transport_.is_receiving());
    EXPECT_TRUE(waiting().empty());
}

TEST_F(Transport, ANewFirstOrSingleFrameBeginsAnew) {
    take_first(counted(60U));
    take_consecutive(counted(60U), 1U, 3U);
    const Bytes message = counted(20U);
    take_first(message);
    take_consecutive(message);
    EXPECT_EQ(waiting(), message);
    transport_.finish(transport_.request());

    take_first(counted(60U));
    take({0x02U, 0x3EU, 0x00U});
    EXPECT_EQ(waiting(), (Bytes{0x3EU, 0x00U}));
    EXPECT_FALSE(transport_.is_receiving());
    cycles(1);
    EXPECT_TRUE(bus_.sent.empty()) << "the flow control is no longer awaited";
}

TEST_F(Transport, AConsecutiveFrameAloneIsNothing) {
    take({0x21U, 1U, 2U, 3U, 4U, 5U, 6U, 7U});
    take({0x40U, 1U});
    EXPECT_TRUE(waiting().empty());
    EXPECT_FALSE(transport_.is_receiving());
}

// N_Cr.
TEST_F(Transport, GivesUpASenderThatIsSilentForASecond) {
    const Bytes message = counted(20U);
    take_first(message);
    cycles(99);
    take_consecutive(message, 1U, 1U);
    cycles(99);
    EXPECT_TRUE(transport_.is_receiving());
    cycles(1);
    EXPECT_FALSE(transport_.is_receiving());
    take_consecutive(message, 2U);
    EXPECT_TRUE(waiting().empty());
}

TEST_F(Transport, ASenderThatBeginsAnewHasItsWholeSecond) {
    take_first(counted(60U));
    cycles(60);
    take_first(counted(20U));
    cycles(99);
    EXPECT_TRUE(transport_.is_receiving());
    cycles(1);
    EXPECT_FALSE(transport_.is_receiving());
}

TEST_F(Transport, TheFlowControlWaitsForRoomOnTheBus) {
    bus_.room = 0;
    take_first(counted(20U));
    cycles(3);
    EXPECT_TRUE(bus_.sent.empty());
    bus_.room = 5;
    cycles(1);
    EXPECT_EQ(last(), continue_to_send_);
    cycles(1);
    EXPECT_EQ(bus_.sent.size(), 1U) << "it is said once";
}

// A functional request is one frame, and does not disturb a segmented one.
TEST_F(Transport, FunctionalRequestsStandApart) {
    const Bytes message = counted(40U);
    take_first(message);
    take_consecutive(message, 1U, 2U);
    take({0x02U, 0x3EU, 0x80U}, Tester::functional);
    EXPECT_EQ(waiting(), (Bytes{0x3EU, 0x80U}));
    EXPECT_TRUE(transport_.request().is_functional());
    take({0x02U, 0x10U, 0x01U}, Tester::functional);  // while another waits
    EXPECT_EQ(waiting(), (Bytes{0x3EU, 0x80U}));
    take_consecutive(message, 3U);
    const Request functional = transport_.request();
    transport_.finish(functional);
    EXPECT_EQ(waiting(), message);
    EXPECT_FALSE(transport_.request().is_functional());
}

TEST_F(Transport, FunctionalSegmentedRequestsAreNotAnswered) {
    take({0x10U, 20U, 1U, 2U, 3U, 4U, 5U, 6U}, Tester::functional);
    take({0x21U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}, Tester::functional);
    take({0x30U, 0U, 0U}, Tester::functional);
    cycles(2);
    EXPECT_TRUE(bus_.sent.empty());
    EXPECT_TRUE(waiting().empty());
}

TEST_F(Transport, AShortAnswerIsOnePaddedFrame) {
    const Bytes message = counted(7U);
    send(message, 3U);
    EXPECT_TRUE(transport_.is_sending());
    cycles(1);
    EXPECT_EQ(last(), (Bytes{3U, 1U, 2U, 3U, 0xCCU, 0xCCU, 0xCCU, 0xCCU}));
    EXPECT_FALSE(transport_.is_sending());
    send(message, 7U);
    cycles(1);
    EXPECT_EQ(last(), Bytes{7U} + message);
}

TEST_F(Transport, ALongAnswerWaitsForFlowControlAndEveryFrameIsPadded) {
    const Bytes message = counted(250U);
    send(message);
    cycles(5);
    ASSERT_EQ(bus_.sent.size(), 1U);
    EXPECT_EQ(last(), Bytes({0x10U, 250U}) + Bytes(message.begin(), message.begin() + 6));
    take({0x30U, 0U, 0U});
    cycles(20);
    Bytes received(message.begin(), message.begin() + 6);
    for (std::size_t number = 1U; number < bus_.sent.size(); ++number) {
        const rsi::hal::CanFrame& frame = bus_.sent[number];
        EXPECT_EQ(frame.length, 8U);
        EXPECT_EQ(frame.data[0], 0x20U | (number & 0x0FU));
        received.insert(received.end(), frame.data.begin() + 1, frame.data.begin() + 8);
    }
    EXPECT_EQ(received[250], 0xCCU);
    received.resize(250U);
    EXPECT_EQ(received, message);
    EXPECT_FALSE(transport_.is_sending());
}

// The length of the longest answer needs the lower half of the first byte.
TEST_F(Transport, TheLongestAnswerTellsItsLength) {
    const Bytes message = counted(rsi::diagnosis::Response::capacity);
    send(message);
    EXPECT_FALSE(response_.is_too_long());
    cycles(1);
    EXPECT_EQ(last(), Bytes({0x11U, 0x00U}) + Bytes(message.begin(), message.begin() + 6));
    take({0x30U, 0U, 0U});
    cycles(20);
    EXPECT_EQ(bus_.sent.size(), 1U + 36U);
    EXPECT_EQ(bus_.sent.back().data[5], message.back());
    EXPECT_FALSE(transport_.is_sending());
}

TEST_F(Transport, SendsAFewFramesACycle) {
    const Bytes message = counted(100U);
    send(message);
    cycles(1);
    take({0x30U, 0U, 0U});
    EXPECT_EQ(rhythm(5), (std::vector<std::size_t>{4U, 4U, 4U, 2U, 0U}));
}

TEST_F(Transport, HonoursBlockSizes) {
    const Bytes message = counted(60U);  // 8 consecutive frames
    send(message);
    cycles(1);
    take({0x30U, 3U, 0U});
    EXPECT_EQ(rhythm(3), (std::vector<std::size_t>{3U, 0U, 0U}));
    take({0x30U, 1U, 0U});
    EXPECT_EQ(rhythm(2), (std::vector<std::size_t>{1U, 0U}));
    take({0x30U, 4U, 0U});
    EXPECT_EQ(rhythm(2), (std::vector<std::size_t>{4U, 0U}));
    EXPECT_FALSE(transport_.is_sending());
    take({0x30U, 0U, 0U});
    EXPECT_EQ(rhythm(1), (std::vector<std::size_t>{0U}));
}

// A separation is one of frames within a block: a new flow control may have another.
TEST_F(Transport, ABlockBeginsAtOnce) {
    send(counted(60U));
    cycles(1);
    take({0x30U, 1U, 0x7FU});
    EXPECT_EQ(rhythm(2), (std::vector<std::size_t>{1U, 0U}));
    take({0x30U, 0U, 0U});
    EXPECT_EQ(rhythm(1), (std::vector<std::size_t>{4U}));
}

struct Separation {
    std::uint8_t time;
    int cycles;
};

class SeparationTimes : public Transport, public ::testing::WithParamInterface<Separation> {};

// Never sooner than asked for.
TEST_P(SeparationTimes, AreHonoured) {
    const Bytes message = counted(20U);  // 2 consecutive frames
    send(message);
    cycles(1);
    take({0x30U, 0U, GetParam().time});
    cycles(1);
    EXPECT_EQ(bus_.sent.size(), 2U);
    cycles(GetParam().cycles - 1);
    EXPECT_EQ(bus_.sent.size(), 2U);
    cycles(1);
    EXPECT_EQ(bus_.sent.size(), 3U);
    EXPECT_FALSE(transport_.is_sending());
}

INSTANTIATE_TEST_SUITE_P(All, SeparationTimes,
                         ::testing::Values(Separation{1U, 1}, Separation{9U, 1}, Separation{10U, 2},
                                           Separation{0x7FU, 13}, Separation{0x80U, 13},
                                           Separation{0xF0U, 13}, Separation{0xF1U, 1}, Separation{0xF9U, 1},
                                           Separation{0xFAU, 13}, Separation{0xFFU, 13}));

// N_Bs.
TEST_F(Transport, GivesUpATesterThatIsSilentForASecond) {
    const Bytes message = counted(60U);
    send(message);
    cycles(1);
    cycles(100);
    EXPECT_TRUE(transport_.is_sending());
    cycles(1);
    EXPECT_FALSE(transport_.is_sending());
    take({0x30U, 0U, 0U});
    EXPECT_EQ(rhythm(1), (std::vector<std::size_t>{0U}));
}

// Also after the second flow control, which others have forgotten.
TEST_F(Transport, GivesUpAfterALaterFlowControlToo) {
    const Bytes message = counted(60U);
    send(message);
    cycles(1);
    take({0x30U, 1U, 0U});
    cycles(1);
    take({0x30U, 1U, 0U});
    cycles(100);
    EXPECT_TRUE(transport_.is_sending());
    cycles(2);
    EXPECT_FALSE(transport_.is_sending());
}

TEST_F(Transport, ATesterMayAskForTimeButNotForEver) {
    const Bytes message = counted(60U);
    send(message);
    cycles(1);
    for (int wait = 0; wait < 10; ++wait) {
        cycles(90);
        take({0x31U, 0U, 0U});
        EXPECT_TRUE(transport_.is_sending()) << wait;
    }
    take({0x31U, 0U, 0U});
    EXPECT_FALSE(transport_.is_sending());
}

TEST_F(Transport, EachWaitGivesTheTesterAnotherSecond) {
    send(counted(60U));
    cycles(1);
    take({0x31U, 0U, 0U});
    cycles(100);
    EXPECT_TRUE(transport_.is_sending());
    cycles(1);
    EXPECT_FALSE(transport_.is_sending());
}

// As many in a row as may be: after a block, and with the next answer, they count anew.
TEST_F(Transport, WaitsCountInARow) {
    const auto wait_ten_times = [&] {
        for (int wait = 0; wait < 10; ++wait) {
            take({0x31U, 0U, 0U});
            EXPECT_TRUE(transport_.is_sending()) << wait;
        }
    };
    for (int answer = 0; answer < 2; ++answer) {
        send(counted(60U));
        cycles(1);
        wait_ten_times();
        take({0x30U, 1U, 0U});
        cycles(1);
        wait_ten_times();
        take({0x31U, 0U, 0U});
        EXPECT_FALSE(transport_.is_sending());
    }
}

TEST_F(Transport, ATesterWithoutRoomOrSenseEndsIt) {
    const Bytes message = counted(60U);
    for (const std::uint8_t status : Bytes{0x32U, 0x33U, 0x3FU}) {
        send(message);
        cycles(1);
        take({status, 0U, 0U});
        EXPECT_FALSE(transport_.is_sending()) << status;
    }
}

TEST_F(Transport, ACutOffFlowControlIsNone) {
    const Bytes message = counted(60U);
    send(message);
    take({0x30U, 0U, 0U});  // before it was asked for
    cycles(1);
    take({0x30U, 0U});
    EXPECT_EQ(rhythm(1), (std::vector<std::size_t>{0U}));
    EXPECT_TRUE(transport_.is_sending());
}

// N_As.
TEST_F(Transport, WaitsForRoomOnTheBusForASecond) {
    const Bytes message = counted(60U);
    bus_.room = 0;
    send(message);
    cycles(100);
    EXPECT_TRUE(transport_.is_sending());
    bus_.room = 2;
    cycles(1);
    take({0x30U, 0U, 0U});
    cycles(1);
    EXPECT_EQ(bus_.sent.size(), 2U);
    cycles(100);
    EXPECT_TRUE(transport_.is_sending());
    cycles(1);
    EXPECT_FALSE(transport_.is_sending());
}

// Its second begins with the flow control, however late that came.
TEST_F(Transport, ABlockWaitsForRoomOnTheBusForASecond) {
    send(counted(60U));
    cycles(1);
    cycles(90);
    take({0x30U, 0U, 0U});
    bus_.room = 0;
    cycles(100);
    EXPECT_TRUE(transport_.is_sending());
    cycles(1);
    EXPECT_FALSE(transport_.is_sending());
}

TEST_F(Transport, AnAnswerAfterOneThatWasGivenUpHasItsWholeSecond) {
    bus_.room = 0;
    for (int answer = 0; answer < 2; ++answer) {
        send(counted(3U));
        cycles(100);
        EXPECT_TRUE(transport_.is_sending());
        cycles(1);
        EXPECT_FALSE(transport_.is_sending());
    }
}

TEST_F(Transport, ARequestWhileAnotherWaitsOrAnAnswerGoesOutIsNotTaken) {
    take({0x02U, 0x3EU, 0x00U});
    take({0x02U, 0x10U, 0x03U});
    EXPECT_EQ(waiting(), (Bytes{0x3EU, 0x00U}));
    transport_.finish(transport_.request());
    const Bytes message = counted(60U);
    send(message);
    cycles(1);
    take({0x02U, 0x10U, 0x03U});
    take_first(counted(20U));
    cycles(1);
    EXPECT_TRUE(waiting().empty());
    EXPECT_EQ(bus_.sent.size(), 1U);
}

// To a functional request, which came in the middle of the physical one.
TEST_F(Transport, ARequestThatHadBegunGoesOnWhileAnAnswerGoesOut) {
    const Bytes request = counted(30U);
    const Bytes answer = counted(60U);
    take_first(request);
    take_consecutive(request, 1U, 1U);
    send(answer);
    cycles(1);
    take_consecutive(request, 2U);
    EXPECT_EQ(waiting(), request);
}

}  // namespace
}  // namespace testing_diagnosis
