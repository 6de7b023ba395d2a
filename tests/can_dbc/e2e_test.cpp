// End-to-end protection, profile 11: what a sender writes and what a receiver makes of it.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "rsi/can_dbc/e2e/profile_11.hpp"

namespace e2e_test {
namespace {

using rsi::can_dbc::e2e::CheckError;
using rsi::can_dbc::e2e::CheckResult;
using rsi::can_dbc::e2e::CheckStatus;
using rsi::can_dbc::e2e::Profile11Receiver;
using rsi::can_dbc::e2e::Profile11Sender;

using Payload = std::array<std::uint8_t, 8>;

constexpr std::uint16_t data_id = 0x3A7U;

Payload frame(unsigned counter, std::uint16_t identifier = data_id) {
    Payload payload{0U, 0U, 0x11U, 0x22U, 0x33U, 0x44U, 0x55U, 0x66U};
    rsi::can_dbc::e2e::protect_profile_11(payload, identifier, static_cast<std::uint8_t>(counter));
    return payload;
}

CheckResult check(Profile11Receiver& receiver, unsigned counter) {
    return receiver.check(frame(counter), 8U);
}

constexpr Payload protected_zeros() {
    Payload payload{};
    rsi::can_dbc::e2e::protect_profile_11(payload, 0x123U, 0U);
    return payload;
}

TEST(Crc8SaeJ1850, GivesTheCatalogueCheckValue) {
    constexpr std::array<std::uint8_t, 9> digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    static_assert(rsi::can_dbc::e2e::Crc8SaeJ1850::checksum(digits.data(), digits.size()) == 0x4BU);
    EXPECT_EQ(rsi::can_dbc::e2e::Crc8SaeJ1850::checksum(digits.data(), digits.size()), 0x4BU);
}

TEST(Crc8SaeJ1850, HasATableThatIsTheDivisionBitByBit) {
    for (const unsigned polynomial : {0x1DU, 0x2FU}) {
        const std::array<std::uint8_t, 256> table =
            rsi::can_dbc::e2e::detail::make_crc_table<std::uint8_t>(static_cast<std::uint8_t>(polynomial));
        for (unsigned byte = 0U; byte < 256U; ++byte) {
            unsigned remainder = byte << 8U;
            for (unsigned bit = 15U; bit >= 8U; --bit) {
                remainder ^= ((remainder >> bit) & 1U) * ((0x100U | polynomial) << (bit - 8U));
            }
            EXPECT_EQ(table[byte], remainder) << byte;
        }
    }
}

TEST(Profile11, RefusesAPayloadTooShortForItsHeaderThoughThatIsWhatIsExpected) {
    const Payload payload{};
    for (const std::size_t length : {0U, 1U}) {
        EXPECT_EQ(rsi::can_dbc::e2e::verify_profile_11(payload.data(), length, length, data_id),
                  CheckError::length);
    }
}

TEST(Profile11, GivesTheReferenceVectorForZerosAndDataIdentifier123) {
    static_assert(protected_zeros()[0] == 0x2AU && protected_zeros()[1] == 0x10U);
    EXPECT_EQ(protected_zeros(), (Payload{0x2AU, 0x10U, 0U, 0U, 0U, 0U, 0U, 0U}));
}

TEST(Profile11, LeavesTheSignalsAlone) {
    const Payload payload = frame(7U);
    for (std::size_t byte = 2U; byte < payload.size(); ++byte) {
        EXPECT_EQ(payload[byte], 0x11U * (byte - 1U));
    }
    EXPECT_EQ(payload[1], 0x37U);
}

TEST(Profile11Sender, CountsFromZeroToFourteenAndStartsAgain) {
    Profile11Sender sender{data_id};
    for (unsigned cycle = 0U; cycle < 40U; ++cycle) {
        Payload payload{};
        sender.protect(payload);
        EXPECT_EQ(payload[1] & 0x0FU, cycle % 15U);
    }
}

TEST(Profile11Receiver, AcceptsEverythingAProperSenderSends) {
    Profile11Sender sender{data_id};
    Profile11Receiver receiver{data_id, 8U, 1U};
    for (unsigned cycle = 0U; cycle < 40U; ++cycle) {
        Payload payload{static_cast<std::uint8_t>(cycle), 0U, static_cast<std::uint8_t>(cycle * 7U)};
        sender.protect(payload);
        EXPECT_EQ(receiver.check(payload, payload.size()).status, CheckStatus::ok) << "cycle " << cycle;
    }
}

TEST(Profile11Receiver, AcceptsAnyCounterFirst) {
    for (unsigned counter = 0U; counter <= 14U; ++counter) {
        Profile11Receiver receiver{data_id, 8U, 1U};
        EXPECT_EQ(check(receiver, counter).status, CheckStatus::ok);
    }
}

TEST(Profile11Receiver, NoticesEverySingleFlippedBit) {
    for (unsigned bit = 0U; bit < 64U; ++bit) {
        Profile11Receiver receiver{data_id, 8U, 1U};
        Payload payload = frame(3U);
        payload[bit / 8U] = static_cast<std::uint8_t>(payload[bit / 8U] ^ (1U << (bit % 8U)));
        const CheckResult result = receiver.check(payload, payload.size());
        EXPECT_EQ(result.status, CheckStatus::error) << "bit " << bit;
        EXPECT_EQ(result.error, CheckError::crc) << "bit " << bit;
    }
}

TEST(Profile11Receiver, RefusesAnotherFramesDataIdentifier) {
    Profile11Receiver receiver{data_id, 8U, 1U};
    EXPECT_EQ(receiver.check(frame(0U, 0x45CU), 8U).error, CheckError::crc);
    // the same low byte: the CRC agrees, the nibble does not
    EXPECT_EQ(receiver.check(frame(0U, data_id ^ 0x100U), 8U).error, CheckError::data_id);
}

TEST(Profile11Receiver, RefusesAWrongLength) {
    for (std::size_t length : {0U, 1U, 2U, 7U}) {
        Profile11Receiver receiver{data_id, 8U, 1U};
        EXPECT_EQ(receiver.check(frame(0U), length).error, CheckError::length) << length;
    }
    Profile11Receiver receiver{data_id, 8U, 1U};
    std::array<std::uint8_t, 64> longer{};
    EXPECT_EQ(receiver.check(longer, 9U).error, CheckError::length);
    EXPECT_EQ(receiver.check(frame(0U), 64U).error, CheckError::length);  // says more than the array has
    EXPECT_EQ(check(receiver, 0U).status, CheckStatus::ok);
}

TEST(Profile11Receiver, RefusesALengthThatTheArrayDoesNotHave) {
    Profile11Receiver receiver{data_id, 64U, 1U};
    EXPECT_EQ(receiver.check(frame(0U), 64U).error, CheckError::length);
}

TEST(Profile11Receiver, RefusesTheCounterValueFifteen) {
    Profile11Receiver receiver{data_id, 8U, 14U};
    EXPECT_EQ(check(receiver, 15U).error, CheckError::counter);
}

TEST(Profile11Receiver, CallsTheSameCounterRepeatedAndGoesOn) {
    Profile11Receiver receiver{data_id, 8U, 1U};
    check(receiver, 4U);
    EXPECT_EQ(check(receiver, 4U).status, CheckStatus::repeated);
    EXPECT_EQ(check(receiver, 4U).status, CheckStatus::repeated);
    EXPECT_EQ(check(receiver, 5U).status, CheckStatus::ok);
}

TEST(Profile11Receiver, ToleratesLostFramesUpToItsLimitFromEveryCounter) {
    for (unsigned start = 0U; start <= 14U; ++start) {
        for (unsigned step = 2U; step <= 14U; ++step) {
            Profile11Receiver receiver{data_id, 8U, 3U};
            check(receiver, start);
            const CheckResult result = check(receiver, (start + step) % 15U);
            EXPECT_EQ(result.status, step <= 3U ? CheckStatus::ok_some_lost : CheckStatus::wrong_sequence);
            EXPECT_EQ(result.lost_frames, step - 1U);
        }
    }
}

TEST(Profile11Receiver, IsBackInStepOneFrameAfterAWrongSequence) {
    Profile11Receiver receiver{data_id, 8U, 1U};
    check(receiver, 0U);
    EXPECT_EQ(check(receiver, 9U).status, CheckStatus::wrong_sequence);
    EXPECT_EQ(check(receiver, 10U).status, CheckStatus::ok);
}

TEST(Profile11Receiver, SeesADamagedFrameAsLost) {
    Profile11Receiver receiver{data_id, 8U, 2U};
    check(receiver, 6U);
    Payload damaged = frame(7U);
    damaged[5] = static_cast<std::uint8_t>(damaged[5] ^ 0x40U);
    EXPECT_EQ(receiver.check(damaged, 8U).status, CheckStatus::error);
    const CheckResult next = check(receiver, 8U);
    EXPECT_EQ(next.status, CheckStatus::ok_some_lost);
    EXPECT_EQ(next.lost_frames, 1U);
}

TEST(Profile11Receiver, ReportsACycleWithoutAFrame) {
    const Profile11Receiver receiver{data_id, 8U, 1U};
    EXPECT_EQ(receiver.no_frame().status, CheckStatus::no_new_data);
}

TEST(CheckStatus, OnlyFramesInSequenceAreUsable) {
    EXPECT_TRUE(is_usable(CheckStatus::ok));
    EXPECT_TRUE(is_usable(CheckStatus::ok_some_lost));
    for (const CheckStatus status :
         {CheckStatus::repeated, CheckStatus::wrong_sequence, CheckStatus::error, CheckStatus::no_new_data}) {
        EXPECT_FALSE(is_usable(status));
    }
}

TEST(Profile11, ChecksAPayloadOfNothingButItsHeader) {
    std::array<std::uint8_t, 2> payload{};
    rsi::can_dbc::e2e::protect_profile_11(payload, data_id, 3U);
    EXPECT_EQ(rsi::can_dbc::e2e::verify_profile_11(payload.data(), 2U, 2U, data_id), CheckError::none);
}

}  // namespace
}  // namespace e2e_test
