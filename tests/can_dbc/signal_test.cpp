// Single signals, with ranges that the CAN database has none of.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "rsi/can_dbc/codec/integer_signal.hpp"
#include "rsi/can_dbc/codec/physical_signal.hpp"

namespace signal_test {
namespace {

using rsi::can_dbc::ByteOrder;
using rsi::can_dbc::EnumerationSignal;
using rsi::can_dbc::IntegerSignal;
using rsi::can_dbc::PhysicalSignal;
using rsi::can_dbc::SignalStatus;

using Payload = std::array<std::uint8_t, 8>;

// Half a unit a code. The range ends between two codes, so the outermost ones are -1 and 1.
constexpr PhysicalSignal<std::int32_t> narrow{
    {ByteOrder::little_endian, 0U, 8U, true}, 0.5F, 0.0F, 1.0F, -0.8F, 0.8F, -1, 1, -128, true};
// The same, falling: the larger the value, the smaller the code; without a code for "not available".
constexpr PhysicalSignal<std::int32_t> falling{
    {ByteOrder::little_endian, 0U, 8U, true}, -0.5F, 0.0F, 1.0F, -0.8F, 0.8F, 1, -1, 0, false};

float decoded(const PhysicalSignal<std::int32_t>& signal, int raw, SignalStatus& status) {
    Payload payload{static_cast<std::uint8_t>(raw & 0xFF)};
    float value = 0.0F;
    rsi::can_dbc::read_signal(signal, payload.data(), value, status);
    return value;
}

TEST(PhysicalSignal, IsNotRoundedToACodeBeyondARangeThatEndsBetweenTwo) {
    EXPECT_EQ(rsi::can_dbc::raw_from_physical(narrow, 0.79F), 1);
    EXPECT_EQ(rsi::can_dbc::raw_from_physical(narrow, -0.79F), -1);
    EXPECT_EQ(rsi::can_dbc::raw_from_physical(falling, 0.79F), -1);
    EXPECT_EQ(rsi::can_dbc::raw_from_physical(falling, -0.79F), 1);
    EXPECT_EQ(rsi::can_dbc::raw_from_physical(narrow, 0.3F), 1);
    EXPECT_EQ(rsi::can_dbc::raw_from_physical(narrow, 0.2F), 0);
}

TEST(PhysicalSignal, WithANegativeFactorHasItsRangeToo) {
    SignalStatus status{};
    for (const int raw : {-2, 2, 100, -128}) {
        EXPECT_TRUE(std::isnan(decoded(falling, raw, status))) << raw;
        EXPECT_EQ(status, SignalStatus::out_of_range) << raw;
    }
    for (const int raw : {-1, 0, 1}) {
        EXPECT_EQ(decoded(falling, raw, status), -0.5F * static_cast<float>(raw));
        EXPECT_EQ(status, SignalStatus::valid) << raw;
    }
}

TEST(PhysicalSignal, WithoutACodeForNotAvailableSendsItsStartValueForNan) {
    EXPECT_EQ(rsi::can_dbc::raw_from_physical(falling, rsi::can_dbc::not_available), 0);
    EXPECT_EQ(rsi::can_dbc::raw_from_physical(narrow, rsi::can_dbc::not_available), -128);
    SignalStatus status{};
    decoded(falling, 0, status);
    EXPECT_EQ(status, SignalStatus::valid);
    decoded(narrow, -128, status);
    EXPECT_EQ(status, SignalStatus::not_available);
}

TEST(IntegerSignal, SaturatesAtBothEndsOfItsRangeAndTakesNothingBeyondThem) {
    constexpr IntegerSignal signal{{ByteOrder::little_endian, 0U, 8U, true}, -10, 20, 5};
    for (const auto& [value, sent] : {std::array{-11, -10}, {-10, -10}, {0, 0}, {20, 20}, {21, 20}}) {
        Payload payload{};
        rsi::can_dbc::write_signal(signal, static_cast<std::int16_t>(value), payload.data());
        EXPECT_EQ(static_cast<std::int8_t>(payload[0]), sent) << value;
    }
    for (const auto& [raw, value] : {std::array{-11, 5}, {-10, -10}, {20, 20}, {21, 5}}) {
        const Payload payload{static_cast<std::uint8_t>(raw & 0xFF)};
        std::int16_t read = 0;
        SignalStatus status{};
        rsi::can_dbc::read_signal(signal, payload.data(), read, status);
        EXPECT_EQ(read, value) << raw;
        EXPECT_EQ(status, raw == value ? SignalStatus::valid : SignalStatus::out_of_range) << raw;
    }
}

enum class Gear : std::uint8_t { park = 0, drive = 1, not_available = 7 };

bool is_gear(Gear gear) {
    return gear == Gear::park || gear == Gear::drive || gear == Gear::not_available;
}

TEST(EnumerationSignal, KnowsItsOwnNotAvailableWhereItHasOne) {
    for (const bool has : {true, false}) {
        const EnumerationSignal signal{{ByteOrder::little_endian, 0U, 8U, false}, 0, has, 7};
        for (const Gear gear : {Gear::park, Gear::drive, Gear::not_available}) {
            const Payload payload{static_cast<std::uint8_t>(gear)};
            Gear read{};
            SignalStatus status{};
            rsi::can_dbc::read_enumeration(signal, &is_gear, payload.data(), read, status);
            EXPECT_EQ(read, gear);
            EXPECT_EQ(status,
                      has && gear == Gear::not_available ? SignalStatus::not_available : SignalStatus::valid);
        }
    }
}

}  // namespace
}  // namespace signal_test
