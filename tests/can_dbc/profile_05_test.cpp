// End-to-end protection, profile 5: what a sender writes and what a receiver makes of it.
#include "can_dbc/e2e/profile_05.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "tests/can_dbc/can_fd.hpp"

namespace profile_05_test {
namespace {

using can_dbc::e2e::CheckError;
using can_dbc::e2e::CheckResult;
using can_dbc::e2e::CheckStatus;
using can_dbc::e2e::Profile05Receiver;
using can_dbc::e2e::Profile05Sender;

constexpr std::uint16_t data_id = 0x1234U;
constexpr std::size_t offset = 8U;

using Payload = std::array<std::uint8_t, 24>;

Payload frame(unsigned counter, std::uint16_t identifier = data_id) {
    Payload payload{};
    for (std::size_t byte = 0U; byte < payload.size(); ++byte) {
        payload[byte] = static_cast<std::uint8_t>(0x11U * byte);
    }
    can_dbc::e2e::protect_profile_05<offset>(payload, identifier, static_cast<std::uint8_t>(counter));
    return payload;
}

Profile05Receiver<offset> receiver_with(std::uint8_t largest_counter_step) {
    return Profile05Receiver<offset>{data_id, Payload{}.size(), largest_counter_step};
}

CheckResult check(Profile05Receiver<offset>& receiver, unsigned counter) {
    return receiver.check(frame(counter), Payload{}.size());
}

template <std::size_t at, std::size_t size>
constexpr std::array<std::uint8_t, size> protected_zeros(std::uint8_t counter) {
    std::array<std::uint8_t, size> payload{};
    can_dbc::e2e::protect_profile_05<at>(payload, data_id, counter);
    return payload;
}

TEST(Crc16CcittFalse, HasATableThatIsTheDivisionBitByBit) {
    for (const unsigned polynomial : {0x1021U, 0x8005U}) {
        const std::array<std::uint16_t, 256> table =
            can_dbc::e2e::detail::make_crc_table<std::uint16_t>(static_cast<std::uint16_t>(polynomial));
        for (unsigned byte = 0U; byte < 256U; ++byte) {
            unsigned remainder = byte << 16U;
            for (unsigned bit = 23U; bit >= 16U; --bit) {
                remainder ^= ((remainder >> bit) & 1U) * ((0x10000U | polynomial) << (bit - 16U));
            }
            EXPECT_EQ(table[byte], remainder) << byte;
        }
    }
}

TEST(Crc16CcittFalse, GivesTheCatalogueCheckValue) {
    constexpr std::array<std::uint8_t, 9> digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    static_assert(can_dbc::e2e::Crc16CcittFalse::checksum(digits.data(), digits.size()) == 0x29B1U);
    EXPECT_EQ(can_dbc::e2e::Crc16CcittFalse::checksum(digits.data(), digits.size()), 0x29B1U);
}

TEST(Profile05, GivesTheReferenceVectorsForZerosAndDataIdentifier1234) {
    static_assert(protected_zeros<0U, 8U>(0U)[0] == 0x1CU && protected_zeros<0U, 8U>(0U)[1] == 0xCAU);
    EXPECT_EQ((protected_zeros<0U, 8U>(0U)), (std::array<std::uint8_t, 8>{0x1CU, 0xCAU}));
    EXPECT_EQ((protected_zeros<0U, 8U>(1U)), (std::array<std::uint8_t, 8>{0xCFU, 0x8DU, 0x01U}));
    EXPECT_EQ((protected_zeros<8U, 16U>(0U)),
              (std::array<std::uint8_t, 16>{0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0x28U, 0x91U}));
}

TEST(Profile05, LeavesTheSignalsAlone) {
    const Payload payload = frame(7U);
    for (std::size_t byte = 0U; byte < payload.size(); ++byte) {
        if (byte < offset || byte > offset + 2U) {
            EXPECT_EQ(payload[byte], (0x11U * byte) & 0xFFU) << byte;
        }
    }
    EXPECT_EQ(payload[offset + 2U], 7U);
}

TEST(Profile05Sender, CountsFromZeroTo255AndStartsAgain) {
    Profile05Sender<> sender{data_id};
    for (unsigned cycle = 0U; cycle < 600U; ++cycle) {
        std::array<std::uint8_t, 8> payload{};
        sender.protect(payload);
        EXPECT_EQ(payload[2], cycle % 256U);
    }
}

TEST(Profile05Receiver, AcceptsEverythingAProperSenderSends) {
    Profile05Sender<offset> sender{data_id};
    auto receiver = receiver_with(1U);
    for (unsigned cycle = 0U; cycle < 600U; ++cycle) {
        Payload payload{static_cast<std::uint8_t>(cycle), static_cast<std::uint8_t>(cycle * 7U)};
        sender.protect(payload);
        EXPECT_EQ(receiver.check(payload, payload.size()).status, CheckStatus::ok) << "cycle " << cycle;
    }
}

// As generated code is used: the message names its own offset, length and data identifier.
template <typename Message>
void expect_signals_carried(const Message& message) {
    static_assert(Message::flexible_data_rate && Message::e2e_protected && Message::e2e_profile == 5U);
    Profile05Sender<Message::e2e_offset> sender{Message::e2e_data_id};
    Profile05Receiver<Message::e2e_offset> receiver{Message::e2e_data_id, Message::length, 1U};
    for (int cycle = 0; cycle < 3; ++cycle) {
        auto payload = can_dbc::encode(message);
        sender.protect(payload);
        EXPECT_EQ(receiver.check(payload, payload.size()).status, CheckStatus::ok);
        EXPECT_EQ(can_dbc::encode(can_dbc::decode<Message>(payload).value), can_dbc::encode(message));
        EXPECT_TRUE(can_dbc::decode<Message>(payload).status.all_valid());
    }
}

TEST(Profile05, CarriesTheSignalsOfGeneratedMessages) {
    expect_signals_carried(can_fd::CornerForces{4200.0F, -150.5F, 3U, 1234.56F, -2.0e6F});
    expect_signals_carried(can_fd::BodyMotion{-12.34F, 56.78F, true, -3.5F});
    static_assert(can_fd::CornerForces::e2e_offset == 0U && can_fd::BodyMotion::e2e_offset == 8U);
    static_assert(can_fd::PlainFd::flexible_data_rate && !can_fd::PlainFd::e2e_protected);
}

TEST(Profile05Receiver, AcceptsAnyCounterFirst) {
    for (unsigned counter = 0U; counter <= 255U; ++counter) {
        auto receiver = receiver_with(1U);
        EXPECT_EQ(check(receiver, counter).status, CheckStatus::ok);
    }
}

TEST(Profile05Receiver, NoticesEverySingleFlippedBit) {
    for (std::size_t bit = 0U; bit < Payload{}.size() * 8U; ++bit) {
        auto receiver = receiver_with(1U);
        Payload payload = frame(3U);
        payload[bit / 8U] = static_cast<std::uint8_t>(payload[bit / 8U] ^ (1U << (bit % 8U)));
        const CheckResult result = receiver.check(payload, payload.size());
        EXPECT_EQ(result.status, CheckStatus::error) << "bit " << bit;
        EXPECT_EQ(result.error, CheckError::crc) << "bit " << bit;
    }
}

TEST(Profile05Receiver, RefusesEveryDataIdentifierThatDiffersInOneBit) {
    for (unsigned bit = 0U; bit < 16U; ++bit) {
        auto receiver = receiver_with(1U);
        const auto other = static_cast<std::uint16_t>(data_id ^ (1U << bit));
        EXPECT_EQ(receiver.check(frame(0U, other), Payload{}.size()).error, CheckError::crc) << "bit " << bit;
    }
}

TEST(Profile05Receiver, RefusesAWrongLength) {
    auto receiver = receiver_with(1U);
    for (const std::size_t length : {0U, 1U, 2U, 8U, 10U, 11U, 23U, 64U}) {
        EXPECT_EQ(receiver.check(frame(0U), length).error, CheckError::length) << length;
    }
    const std::array<std::uint8_t, 64> longer{};
    EXPECT_EQ(receiver.check(longer, 32U).error, CheckError::length);
    EXPECT_EQ(check(receiver, 0U).status, CheckStatus::ok);
}

TEST(Profile05Receiver, RefusesALengthThatTheArrayDoesNotHave) {
    Profile05Receiver<offset> receiver{data_id, 64U, 1U};
    EXPECT_EQ(receiver.check(frame(0U), 64U).error, CheckError::length);
}

TEST(Profile05Receiver, RefusesAFrameThatCannotHoldItsHeader) {
    Profile05Receiver<offset> receiver{data_id, 10U, 1U};  // one byte short of offset + 3
    EXPECT_EQ(receiver.check(frame(0U), 10U).error, CheckError::length);
}

TEST(Profile05Receiver, CallsTheSameCounterRepeatedAndGoesOn) {
    auto receiver = receiver_with(1U);
    check(receiver, 4U);
    EXPECT_EQ(check(receiver, 4U).status, CheckStatus::repeated);
    EXPECT_EQ(check(receiver, 4U).status, CheckStatus::repeated);
    EXPECT_EQ(check(receiver, 5U).status, CheckStatus::ok);
}

TEST(Profile05Receiver, ToleratesLostFramesUpToItsLimitFromEveryCounter) {
    for (unsigned start = 0U; start <= 255U; ++start) {
        for (const unsigned step : {2U, 3U, 4U, 128U, 255U}) {
            auto receiver = receiver_with(3U);
            check(receiver, start);
            const CheckResult result = check(receiver, (start + step) % 256U);
            EXPECT_EQ(result.status, step <= 3U ? CheckStatus::ok_some_lost : CheckStatus::wrong_sequence);
            EXPECT_EQ(result.lost_frames, step - 1U);
        }
    }
}

TEST(Profile05Receiver, IsBackInStepOneFrameAfterAWrongSequence) {
    auto receiver = receiver_with(1U);
    check(receiver, 0U);
    EXPECT_EQ(check(receiver, 9U).status, CheckStatus::wrong_sequence);
    EXPECT_EQ(check(receiver, 10U).status, CheckStatus::ok);
}

TEST(Profile05Receiver, SeesADamagedFrameAsLost) {
    auto receiver = receiver_with(2U);
    check(receiver, 6U);
    Payload damaged = frame(7U);
    damaged[20] = static_cast<std::uint8_t>(damaged[20] ^ 0x40U);
    EXPECT_EQ(receiver.check(damaged, damaged.size()).status, CheckStatus::error);
    const CheckResult next = check(receiver, 8U);
    EXPECT_EQ(next.status, CheckStatus::ok_some_lost);
    EXPECT_EQ(next.lost_frames, 1U);
}

TEST(Profile05Receiver, ReportsACycleWithoutAFrame) {
    EXPECT_EQ(receiver_with(1U).no_frame().status, CheckStatus::no_new_data);
}

TEST(Profile05, ChecksAPayloadOfNothingButItsHeader) {
    std::array<std::uint8_t, 3> payload{};
    can_dbc::e2e::protect_profile_05(payload, 0x1234U, 3U);
    EXPECT_EQ(can_dbc::e2e::verify_profile_05(payload.data(), 3U, 3U, 0U, 0x1234U),
              can_dbc::e2e::CheckError::none);
}

}  // namespace
}  // namespace profile_05_test
