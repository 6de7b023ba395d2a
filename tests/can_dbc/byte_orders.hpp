// Codec of byte_orders.dbc, written by can_dbc/generator/generate.py: change the DBC file, not this one.
// clang-format off
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/can_dbc/codec/integer_signal.hpp"
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/codec/physical_signal.hpp"

namespace byte_orders {

using namespace rsi::can_dbc;

// Test message IntelScaledShort.
// From Tester to Target, every 20 ms.
struct IntelScaledShort {
    static constexpr const char* name{"IntelScaledShort"};
    static constexpr std::uint32_t identifier{0x100U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 21 bits, unsigned, raw * 0.1 + -40. Dimensionless, -39.9 to 209675.
    float length21{-39.8F};
    // 13 bits, unsigned, raw * -0.01 + 0.3. Dimensionless, -81.47 to 0.3.
    float length13{not_available};
    // 19 bits, unsigned, raw * 0.00390625 + 0. Dimensionless, 0 to 2047.917.
    float length19{not_available};
    // 22 bits, signed, raw * 0.0174532925 + 0. Dimensionless, -36601.805 to 36602.189.
    float length22{not_available};
    // 10 bits, signed, raw * 1 + 0. Dimensionless, -501 to 511.
    float length10{not_available};
    // 14 bits, signed, raw * -0.5 + 3. Dimensionless, -4092.5 to 4091.5.
    float length14{not_available};
    // 5 bits, unsigned, raw * 0.002 + 0. Dimensionless, 0.002 to 0.06.
    float length05{0.004F};
    // 7 bits, unsigned, raw * 0.25 + -10. Dimensionless, -10 to 19.75.
    float length07{not_available};
    // 4 bits, signed, raw * -0.5 + 3. Dimensionless, 0 to 6.5.
    float length04{2.0F};
    // 16 bits, signed, raw * 7 + -3.5. Dimensionless, -229260.5 to 229365.5.
    float length16{not_available};
    // 6 bits, signed, raw * 7 + -3.5. Dimensionless, -220.5 to 206.5.
    float length06{10.5F};
    // 2 bits, signed, raw * 1 + 0. -2 to 1.
    std::int8_t length02{0};
    // 3 bits, unsigned, raw * 1 + 0. 0 to 7.
    std::uint8_t length03{0U};
    // 18 bits, signed, raw * 50 + 0. Dimensionless, -6553550 to 6553500.
    float length18{100.0F};
    // 11 bits, unsigned, raw * 0.1 + -40. Dimensionless, -40 to 163.5.
    float length11{not_available};
    // 8 bits, signed, raw * 50 + 0. Dimensionless, -5950 to 6350.
    float length08{not_available};
    // 15 bits, unsigned, raw * 0.002 + 0. Dimensionless, 0.002 to 65.532.
    float length15{0.004F};
    // 1 bits, unsigned, raw * 1 + 0.
    bool length01{false};
    // 17 bits, unsigned, raw * 0.25 + -10. Dimensionless, -10 to 32753.25.
    float length17{not_available};
    // 12 bits, signed, raw * 0.0174532925 + 0. Dimensionless, -35.726 to 35.709.
    float length12{0.034906585F};
    // 9 bits, unsigned, raw * 0.00390625 + 0. Dimensionless, 0.004 to 1.992.
    float length09{0.0078125F};
    // 20 bits, signed, raw * 1 + 0. Dimensionless, -524267 to 524287.
    float length20{not_available};

    struct Status {
        SignalStatus length21{SignalStatus::not_available};
        SignalStatus length13{SignalStatus::not_available};
        SignalStatus length19{SignalStatus::not_available};
        SignalStatus length22{SignalStatus::not_available};
        SignalStatus length10{SignalStatus::not_available};
        SignalStatus length14{SignalStatus::not_available};
        SignalStatus length05{SignalStatus::not_available};
        SignalStatus length07{SignalStatus::not_available};
        SignalStatus length04{SignalStatus::not_available};
        SignalStatus length16{SignalStatus::not_available};
        SignalStatus length06{SignalStatus::not_available};
        SignalStatus length02{SignalStatus::not_available};
        SignalStatus length03{SignalStatus::not_available};
        SignalStatus length18{SignalStatus::not_available};
        SignalStatus length11{SignalStatus::not_available};
        SignalStatus length08{SignalStatus::not_available};
        SignalStatus length15{SignalStatus::not_available};
        SignalStatus length01{SignalStatus::not_available};
        SignalStatus length17{SignalStatus::not_available};
        SignalStatus length12{SignalStatus::not_available};
        SignalStatus length09{SignalStatus::not_available};
        SignalStatus length20{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return length21 == SignalStatus::valid &&
                   length13 == SignalStatus::valid &&
                   length19 == SignalStatus::valid &&
                   length22 == SignalStatus::valid &&
                   length10 == SignalStatus::valid &&
                   length14 == SignalStatus::valid &&
                   length05 == SignalStatus::valid &&
                   length07 == SignalStatus::valid &&
                   length04 == SignalStatus::valid &&
                   length16 == SignalStatus::valid &&
                   length06 == SignalStatus::valid &&
                   length02 == SignalStatus::valid &&
                   length03 == SignalStatus::valid &&
                   length18 == SignalStatus::valid &&
                   length11 == SignalStatus::valid &&
                   length08 == SignalStatus::valid &&
                   length15 == SignalStatus::valid &&
                   length01 == SignalStatus::valid &&
                   length17 == SignalStatus::valid &&
                   length12 == SignalStatus::valid &&
                   length09 == SignalStatus::valid &&
                   length20 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> length21{
            {ByteOrder::little_endian, 3U, 21U, false}, 1.0F, -400.0F, 10.0F, -39.9F, 209675.0F,
            1, 2097150, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length13{
            {ByteOrder::little_endian, 26U, 13U, false}, -1.0F, 30.0F, 100.0F, -81.47F, 0.3F,
            8177, 0, 8191, true};
        static constexpr PhysicalSignal<std::int32_t> length19{
            {ByteOrder::little_endian, 40U, 19U, false}, 1.0F, 0.0F, 256.0F, 0.0F, 2047.917F,
            0, 524266, 524287, true};
        static constexpr PhysicalSignal<std::int32_t> length22{
            {ByteOrder::little_endian, 59U, 22U, true}, 6981317.0F, 0.0F, 400000000.0F, -36601.805F, 36602.189F,
            -2097128, 2097150, -2097152, true};
        static constexpr PhysicalSignal<std::int32_t> length10{
            {ByteOrder::little_endian, 83U, 10U, true}, 1.0F, 0.0F, 1.0F, -501.0F, 511.0F,
            -501, 511, -512, true};
        static constexpr PhysicalSignal<std::int32_t> length14{
            {ByteOrder::little_endian, 93U, 14U, true}, -1.0F, 6.0F, 2.0F, -4092.5F, 4091.5F,
            8191, -8177, -8192, true};
        static constexpr PhysicalSignal<std::int32_t> length05{
            {ByteOrder::little_endian, 107U, 5U, false}, 1.0F, 0.0F, 500.0F, 0.002F, 0.06F,
            1, 30, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length07{
            {ByteOrder::little_endian, 112U, 7U, false}, 1.0F, -40.0F, 4.0F, -10.0F, 19.75F,
            0, 119, 127, true};
        static constexpr PhysicalSignal<std::int32_t> length04{
            {ByteOrder::little_endian, 121U, 4U, true}, -1.0F, 6.0F, 2.0F, 0.0F, 6.5F,
            6, -7, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length16{
            {ByteOrder::little_endian, 125U, 16U, true}, 14.0F, -7.0F, 2.0F, -229260.5F, 229365.5F,
            -32751, 32767, -32768, true};
        static constexpr PhysicalSignal<std::int32_t> length06{
            {ByteOrder::little_endian, 141U, 6U, true}, 14.0F, -7.0F, 2.0F, -220.5F, 206.5F,
            -31, 30, 2, false};
        static constexpr IntegerSignal length02{
            {ByteOrder::little_endian, 147U, 2U, true}, -2, 1, 0};
        static constexpr IntegerSignal length03{
            {ByteOrder::little_endian, 149U, 3U, false}, 0, 7, 0};
        static constexpr PhysicalSignal<std::int32_t> length18{
            {ByteOrder::little_endian, 152U, 18U, true}, 50.0F, 0.0F, 1.0F, -6553550.0F, 6553500.0F,
            -131071, 131070, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length11{
            {ByteOrder::little_endian, 170U, 11U, false}, 1.0F, -400.0F, 10.0F, -40.0F, 163.5F,
            0, 2035, 2047, true};
        static constexpr PhysicalSignal<std::int32_t> length08{
            {ByteOrder::little_endian, 181U, 8U, true}, 50.0F, 0.0F, 1.0F, -5950.0F, 6350.0F,
            -119, 127, -128, true};
        static constexpr PhysicalSignal<std::int32_t> length15{
            {ByteOrder::little_endian, 189U, 15U, false}, 1.0F, 0.0F, 500.0F, 0.002F, 65.532F,
            1, 32766, 2, false};
        static constexpr IntegerSignal length01{
            {ByteOrder::little_endian, 205U, 1U, false}, 0, 1, 0};
        static constexpr PhysicalSignal<std::int32_t> length17{
            {ByteOrder::little_endian, 207U, 17U, false}, 1.0F, -40.0F, 4.0F, -10.0F, 32753.25F,
            0, 131053, 131071, true};
        static constexpr PhysicalSignal<std::int32_t> length12{
            {ByteOrder::little_endian, 224U, 12U, true}, 6981317.0F, 0.0F, 400000000.0F, -35.726F, 35.709F,
            -2046, 2045, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length09{
            {ByteOrder::little_endian, 236U, 9U, false}, 1.0F, 0.0F, 256.0F, 0.004F, 1.992F,
            2, 509, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length20{
            {ByteOrder::little_endian, 245U, 20U, true}, 1.0F, 0.0F, 1.0F, -524267.0F, 524287.0F,
            -524267, 524287, -524288, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::length21, length21, payload.data());
        write_signal(Signals::length13, length13, payload.data());
        write_signal(Signals::length19, length19, payload.data());
        write_signal(Signals::length22, length22, payload.data());
        write_signal(Signals::length10, length10, payload.data());
        write_signal(Signals::length14, length14, payload.data());
        write_signal(Signals::length05, length05, payload.data());
        write_signal(Signals::length07, length07, payload.data());
        write_signal(Signals::length04, length04, payload.data());
        write_signal(Signals::length16, length16, payload.data());
        write_signal(Signals::length06, length06, payload.data());
        write_signal(Signals::length02, length02, payload.data());
        write_signal(Signals::length03, length03, payload.data());
        write_signal(Signals::length18, length18, payload.data());
        write_signal(Signals::length11, length11, payload.data());
        write_signal(Signals::length08, length08, payload.data());
        write_signal(Signals::length15, length15, payload.data());
        write_signal(Signals::length01, length01, payload.data());
        write_signal(Signals::length17, length17, payload.data());
        write_signal(Signals::length12, length12, payload.data());
        write_signal(Signals::length09, length09, payload.data());
        write_signal(Signals::length20, length20, payload.data());
        return payload;
    }

    static constexpr Decoded<IntelScaledShort> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Length21", "-", &IntelScaledShort::length21, &Status::length21);
        visitor("Length13", "-", &IntelScaledShort::length13, &Status::length13);
        visitor("Length19", "-", &IntelScaledShort::length19, &Status::length19);
        visitor("Length22", "-", &IntelScaledShort::length22, &Status::length22);
        visitor("Length10", "-", &IntelScaledShort::length10, &Status::length10);
        visitor("Length14", "-", &IntelScaledShort::length14, &Status::length14);
        visitor("Length05", "-", &IntelScaledShort::length05, &Status::length05);
        visitor("Length07", "-", &IntelScaledShort::length07, &Status::length07);
        visitor("Length04", "-", &IntelScaledShort::length04, &Status::length04);
        visitor("Length16", "-", &IntelScaledShort::length16, &Status::length16);
        visitor("Length06", "-", &IntelScaledShort::length06, &Status::length06);
        visitor("Length02", "-", &IntelScaledShort::length02, &Status::length02);
        visitor("Length03", "-", &IntelScaledShort::length03, &Status::length03);
        visitor("Length18", "-", &IntelScaledShort::length18, &Status::length18);
        visitor("Length11", "-", &IntelScaledShort::length11, &Status::length11);
        visitor("Length08", "-", &IntelScaledShort::length08, &Status::length08);
        visitor("Length15", "-", &IntelScaledShort::length15, &Status::length15);
        visitor("Length01", "-", &IntelScaledShort::length01, &Status::length01);
        visitor("Length17", "-", &IntelScaledShort::length17, &Status::length17);
        visitor("Length12", "-", &IntelScaledShort::length12, &Status::length12);
        visitor("Length09", "-", &IntelScaledShort::length09, &Status::length09);
        visitor("Length20", "-", &IntelScaledShort::length20, &Status::length20);
    }
};

constexpr Decoded<IntelScaledShort> IntelScaledShort::decode(const std::uint8_t* payload) {
    Decoded<IntelScaledShort> decoded{};
    read_signal(Signals::length21, payload, decoded.value.length21, decoded.status.length21);
    read_signal(Signals::length13, payload, decoded.value.length13, decoded.status.length13);
    read_signal(Signals::length19, payload, decoded.value.length19, decoded.status.length19);
    read_signal(Signals::length22, payload, decoded.value.length22, decoded.status.length22);
    read_signal(Signals::length10, payload, decoded.value.length10, decoded.status.length10);
    read_signal(Signals::length14, payload, decoded.value.length14, decoded.status.length14);
    read_signal(Signals::length05, payload, decoded.value.length05, decoded.status.length05);
    read_signal(Signals::length07, payload, decoded.value.length07, decoded.status.length07);
    read_signal(Signals::length04, payload, decoded.value.length04, decoded.status.length04);
    read_signal(Signals::length16, payload, decoded.value.length16, decoded.status.length16);
    read_signal(Signals::length06, payload, decoded.value.length06, decoded.status.length06);
    read_signal(Signals::length02, payload, decoded.value.length02, decoded.status.length02);
    read_signal(Signals::length03, payload, decoded.value.length03, decoded.status.length03);
    read_signal(Signals::length18, payload, decoded.value.length18, decoded.status.length18);
    read_signal(Signals::length11, payload, decoded.value.length11, decoded.status.length11);
    read_signal(Signals::length08, payload, decoded.value.length08, decoded.status.length08);
    read_signal(Signals::length15, payload, decoded.value.length15, decoded.status.length15);
    read_signal(Signals::length01, payload, decoded.value.length01, decoded.status.length01);
    read_signal(Signals::length17, payload, decoded.value.length17, decoded.status.length17);
    read_signal(Signals::length12, payload, decoded.value.length12, decoded.status.length12);
    read_signal(Signals::length09, payload, decoded.value.length09, decoded.status.length09);
    read_signal(Signals::length20, payload, decoded.value.length20, decoded.status.length20);
    return decoded;
}

// Test message IntelScaledLong.
// From Tester to Target, every 20 ms.
struct IntelScaledLong {
    static constexpr const char* name{"IntelScaledLong"};
    static constexpr std::uint32_t identifier{0x101U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 32 bits, signed, raw * 0.0174532925 + 0. Dimensionless, -37480660.23 to 37480660.212.
    float length32{0.034906585F};
    // 30 bits, signed, raw * 1 + 0. -536870911 to 536870910.
    std::int32_t length30{2};
    // 28 bits, signed, raw * 50 + 0. Dimensionless, -6710886350 to 6710886300.
    float length28{100.0F};
    // 31 bits, unsigned, raw * 0.1 + -40. Dimensionless, -39.9 to 214748324.6.
    float length31{-39.8F};
    // 24 bits, signed, raw * -0.5 + 3. Dimensionless, -4194300 to 4194306.5.
    float length24{2.0F};
    // 26 bits, signed, raw * 7 + -3.5. Dimensionless, -234881020.5 to 234881006.5.
    float length26{10.5F};
    // 25 bits, unsigned, raw * 0.002 + 0. Dimensionless, 0.002 to 67108.86.
    float length25{0.004F};
    // 23 bits, unsigned, raw * -0.01 + 0.3. Dimensionless, -83885.53 to 0.3.
    float length23{not_available};
    // 27 bits, unsigned, raw * 0.25 + -10. Dimensionless, -9.75 to 33554421.5.
    float length27{-9.5F};
    // 29 bits, unsigned, raw * 0.00390625 + 0. Dimensionless, 0.004 to 2097151.992.
    float length29{0.0078125F};

    struct Status {
        SignalStatus length32{SignalStatus::not_available};
        SignalStatus length30{SignalStatus::not_available};
        SignalStatus length28{SignalStatus::not_available};
        SignalStatus length31{SignalStatus::not_available};
        SignalStatus length24{SignalStatus::not_available};
        SignalStatus length26{SignalStatus::not_available};
        SignalStatus length25{SignalStatus::not_available};
        SignalStatus length23{SignalStatus::not_available};
        SignalStatus length27{SignalStatus::not_available};
        SignalStatus length29{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return length32 == SignalStatus::valid &&
                   length30 == SignalStatus::valid &&
                   length28 == SignalStatus::valid &&
                   length31 == SignalStatus::valid &&
                   length24 == SignalStatus::valid &&
                   length26 == SignalStatus::valid &&
                   length25 == SignalStatus::valid &&
                   length23 == SignalStatus::valid &&
                   length27 == SignalStatus::valid &&
                   length29 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int64_t> length32{
            {ByteOrder::little_endian, 3U, 32U, true}, 6981317.0F, 0.0F, 400000000.0F, -37480660.23F, 37480660.212F,
            -2147483646, 2147483645, 2, false};
        static constexpr IntegerSignal length30{
            {ByteOrder::little_endian, 36U, 30U, true}, -536870911, 536870910, 2};
        static constexpr PhysicalSignal<std::int64_t> length28{
            {ByteOrder::little_endian, 67U, 28U, true}, 50.0F, 0.0F, 1.0F, -6710886350.0F, 6710886300.0F,
            -134217727, 134217726, 2, false};
        static constexpr PhysicalSignal<std::int64_t> length31{
            {ByteOrder::little_endian, 95U, 31U, false}, 1.0F, -400.0F, 10.0F, -39.9F, 214748324.6F,
            1, 2147483646, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length24{
            {ByteOrder::little_endian, 127U, 24U, true}, -1.0F, 6.0F, 2.0F, -4194300.0F, 4194306.5F,
            8388606, -8388607, 2, false};
        static constexpr PhysicalSignal<std::int64_t> length26{
            {ByteOrder::little_endian, 151U, 26U, true}, 14.0F, -7.0F, 2.0F, -234881020.5F, 234881006.5F,
            -33554431, 33554430, 2, false};
        static constexpr PhysicalSignal<std::int64_t> length25{
            {ByteOrder::little_endian, 178U, 25U, false}, 1.0F, 0.0F, 500.0F, 0.002F, 67108.86F,
            1, 33554430, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length23{
            {ByteOrder::little_endian, 204U, 23U, false}, -1.0F, 30.0F, 100.0F, -83885.53F, 0.3F,
            8388583, 0, 8388607, true};
        static constexpr PhysicalSignal<std::int64_t> length27{
            {ByteOrder::little_endian, 228U, 27U, false}, 1.0F, -40.0F, 4.0F, -9.75F, 33554421.5F,
            1, 134217726, 2, false};
        static constexpr PhysicalSignal<std::int64_t> length29{
            {ByteOrder::little_endian, 257U, 29U, false}, 1.0F, 0.0F, 256.0F, 0.004F, 2097151.992F,
            2, 536870909, 2, false};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::length32, length32, payload.data());
        write_signal(Signals::length30, length30, payload.data());
        write_signal(Signals::length28, length28, payload.data());
        write_signal(Signals::length31, length31, payload.data());
        write_signal(Signals::length24, length24, payload.data());
        write_signal(Signals::length26, length26, payload.data());
        write_signal(Signals::length25, length25, payload.data());
        write_signal(Signals::length23, length23, payload.data());
        write_signal(Signals::length27, length27, payload.data());
        write_signal(Signals::length29, length29, payload.data());
        return payload;
    }

    static constexpr Decoded<IntelScaledLong> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Length32", "-", &IntelScaledLong::length32, &Status::length32);
        visitor("Length30", "-", &IntelScaledLong::length30, &Status::length30);
        visitor("Length28", "-", &IntelScaledLong::length28, &Status::length28);
        visitor("Length31", "-", &IntelScaledLong::length31, &Status::length31);
        visitor("Length24", "-", &IntelScaledLong::length24, &Status::length24);
        visitor("Length26", "-", &IntelScaledLong::length26, &Status::length26);
        visitor("Length25", "-", &IntelScaledLong::length25, &Status::length25);
        visitor("Length23", "-", &IntelScaledLong::length23, &Status::length23);
        visitor("Length27", "-", &IntelScaledLong::length27, &Status::length27);
        visitor("Length29", "-", &IntelScaledLong::length29, &Status::length29);
    }
};

constexpr Decoded<IntelScaledLong> IntelScaledLong::decode(const std::uint8_t* payload) {
    Decoded<IntelScaledLong> decoded{};
    read_signal(Signals::length32, payload, decoded.value.length32, decoded.status.length32);
    read_signal(Signals::length30, payload, decoded.value.length30, decoded.status.length30);
    read_signal(Signals::length28, payload, decoded.value.length28, decoded.status.length28);
    read_signal(Signals::length31, payload, decoded.value.length31, decoded.status.length31);
    read_signal(Signals::length24, payload, decoded.value.length24, decoded.status.length24);
    read_signal(Signals::length26, payload, decoded.value.length26, decoded.status.length26);
    read_signal(Signals::length25, payload, decoded.value.length25, decoded.status.length25);
    read_signal(Signals::length23, payload, decoded.value.length23, decoded.status.length23);
    read_signal(Signals::length27, payload, decoded.value.length27, decoded.status.length27);
    read_signal(Signals::length29, payload, decoded.value.length29, decoded.status.length29);
    return decoded;
}

// Test message IntelPlainShort.
// From Tester to Target, every 20 ms.
struct IntelPlainShort {
    static constexpr const char* name{"IntelPlainShort"};
    static constexpr std::uint32_t identifier{0x102U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 18 bits, unsigned, raw * 1 + 0. 0 to 262143.
    std::uint32_t length18{0U};
    // 8 bits, unsigned, raw * 1 + 0. 0 to 255.
    std::uint8_t length08{0U};
    // 3 bits, signed, raw * 1 + 0. -4 to 3.
    std::int8_t length03{0};
    // 11 bits, signed, raw * 1 + 0. -1024 to 1023.
    std::int16_t length11{0};
    // 4 bits, unsigned, raw * 1 + 0. 0 to 15.
    std::uint8_t length04{0U};
    // 15 bits, signed, raw * 1 + 0. -16384 to 16383.
    std::int16_t length15{0};
    // 5 bits, signed, raw * 1 + 0. -16 to 15.
    std::int8_t length05{0};
    // 10 bits, unsigned, raw * 1 + 0. 0 to 1023.
    std::uint16_t length10{0U};
    // 14 bits, unsigned, raw * 1 + 0. 0 to 16383.
    std::uint16_t length14{0U};
    // 13 bits, signed, raw * 1 + 0. -4096 to 4095.
    std::int16_t length13{0};
    // 17 bits, signed, raw * 1 + 0. -65536 to 65535.
    std::int32_t length17{0};
    // 20 bits, unsigned, raw * 1 + 0. 0 to 1048575.
    std::uint32_t length20{0U};
    // 7 bits, signed, raw * 1 + 0. -64 to 63.
    std::int8_t length07{0};
    // 19 bits, signed, raw * 1 + 0. -262144 to 262143.
    std::int32_t length19{0};
    // 12 bits, unsigned, raw * 1 + 0. 0 to 4095.
    std::uint16_t length12{0U};
    // 1 bits, signed, raw * 1 + 0. -1 to 0.
    std::int8_t length01{0};
    // 9 bits, signed, raw * 1 + 0. -256 to 255.
    std::int16_t length09{0};
    // 2 bits, unsigned, raw * 1 + 0. 0 to 3.
    std::uint8_t length02{0U};
    // 22 bits, unsigned, raw * 1 + 0. 0 to 4194303.
    std::uint32_t length22{0U};
    // 21 bits, signed, raw * 1 + 0. -1048576 to 1048575.
    std::int32_t length21{0};
    // 16 bits, unsigned, raw * 1 + 0. 0 to 65535.
    std::uint16_t length16{0U};
    // 6 bits, unsigned, raw * 1 + 0. 0 to 63.
    std::uint8_t length06{0U};

    struct Status {
        SignalStatus length18{SignalStatus::not_available};
        SignalStatus length08{SignalStatus::not_available};
        SignalStatus length03{SignalStatus::not_available};
        SignalStatus length11{SignalStatus::not_available};
        SignalStatus length04{SignalStatus::not_available};
        SignalStatus length15{SignalStatus::not_available};
        SignalStatus length05{SignalStatus::not_available};
        SignalStatus length10{SignalStatus::not_available};
        SignalStatus length14{SignalStatus::not_available};
        SignalStatus length13{SignalStatus::not_available};
        SignalStatus length17{SignalStatus::not_available};
        SignalStatus length20{SignalStatus::not_available};
        SignalStatus length07{SignalStatus::not_available};
        SignalStatus length19{SignalStatus::not_available};
        SignalStatus length12{SignalStatus::not_available};
        SignalStatus length01{SignalStatus::not_available};
        SignalStatus length09{SignalStatus::not_available};
        SignalStatus length02{SignalStatus::not_available};
        SignalStatus length22{SignalStatus::not_available};
        SignalStatus length21{SignalStatus::not_available};
        SignalStatus length16{SignalStatus::not_available};
        SignalStatus length06{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return length18 == SignalStatus::valid &&
                   length08 == SignalStatus::valid &&
                   length03 == SignalStatus::valid &&
                   length11 == SignalStatus::valid &&
                   length04 == SignalStatus::valid &&
                   length15 == SignalStatus::valid &&
                   length05 == SignalStatus::valid &&
                   length10 == SignalStatus::valid &&
                   length14 == SignalStatus::valid &&
                   length13 == SignalStatus::valid &&
                   length17 == SignalStatus::valid &&
                   length20 == SignalStatus::valid &&
                   length07 == SignalStatus::valid &&
                   length19 == SignalStatus::valid &&
                   length12 == SignalStatus::valid &&
                   length01 == SignalStatus::valid &&
                   length09 == SignalStatus::valid &&
                   length02 == SignalStatus::valid &&
                   length22 == SignalStatus::valid &&
                   length21 == SignalStatus::valid &&
                   length16 == SignalStatus::valid &&
                   length06 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr IntegerSignal length18{
            {ByteOrder::little_endian, 3U, 18U, false}, 0, 262143, 0};
        static constexpr IntegerSignal length08{
            {ByteOrder::little_endian, 21U, 8U, false}, 0, 255, 0};
        static constexpr IntegerSignal length03{
            {ByteOrder::little_endian, 29U, 3U, true}, -4, 3, 0};
        static constexpr IntegerSignal length11{
            {ByteOrder::little_endian, 32U, 11U, true}, -1024, 1023, 0};
        static constexpr IntegerSignal length04{
            {ByteOrder::little_endian, 45U, 4U, false}, 0, 15, 0};
        static constexpr IntegerSignal length15{
            {ByteOrder::little_endian, 50U, 15U, true}, -16384, 16383, 0};
        static constexpr IntegerSignal length05{
            {ByteOrder::little_endian, 66U, 5U, true}, -16, 15, 0};
        static constexpr IntegerSignal length10{
            {ByteOrder::little_endian, 72U, 10U, false}, 0, 1023, 0};
        static constexpr IntegerSignal length14{
            {ByteOrder::little_endian, 84U, 14U, false}, 0, 16383, 0};
        static constexpr IntegerSignal length13{
            {ByteOrder::little_endian, 98U, 13U, true}, -4096, 4095, 0};
        static constexpr IntegerSignal length17{
            {ByteOrder::little_endian, 112U, 17U, true}, -65536, 65535, 0};
        static constexpr IntegerSignal length20{
            {ByteOrder::little_endian, 130U, 20U, false}, 0, 1048575, 0};
        static constexpr IntegerSignal length07{
            {ByteOrder::little_endian, 150U, 7U, true}, -64, 63, 0};
        static constexpr IntegerSignal length19{
            {ByteOrder::little_endian, 159U, 19U, true}, -262144, 262143, 0};
        static constexpr IntegerSignal length12{
            {ByteOrder::little_endian, 178U, 12U, false}, 0, 4095, 0};
        static constexpr IntegerSignal length01{
            {ByteOrder::little_endian, 190U, 1U, true}, -1, 0, 0};
        static constexpr IntegerSignal length09{
            {ByteOrder::little_endian, 192U, 9U, true}, -256, 255, 0};
        static constexpr IntegerSignal length02{
            {ByteOrder::little_endian, 202U, 2U, false}, 0, 3, 0};
        static constexpr IntegerSignal length22{
            {ByteOrder::little_endian, 204U, 22U, false}, 0, 4194303, 0};
        static constexpr IntegerSignal length21{
            {ByteOrder::little_endian, 227U, 21U, true}, -1048576, 1048575, 0};
        static constexpr IntegerSignal length16{
            {ByteOrder::little_endian, 249U, 16U, false}, 0, 65535, 0};
        static constexpr IntegerSignal length06{
            {ByteOrder::little_endian, 265U, 6U, false}, 0, 63, 0};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::length18, length18, payload.data());
        write_signal(Signals::length08, length08, payload.data());
        write_signal(Signals::length03, length03, payload.data());
        write_signal(Signals::length11, length11, payload.data());
        write_signal(Signals::length04, length04, payload.data());
        write_signal(Signals::length15, length15, payload.data());
        write_signal(Signals::length05, length05, payload.data());
        write_signal(Signals::length10, length10, payload.data());
        write_signal(Signals::length14, length14, payload.data());
        write_signal(Signals::length13, length13, payload.data());
        write_signal(Signals::length17, length17, payload.data());
        write_signal(Signals::length20, length20, payload.data());
        write_signal(Signals::length07, length07, payload.data());
        write_signal(Signals::length19, length19, payload.data());
        write_signal(Signals::length12, length12, payload.data());
        write_signal(Signals::length01, length01, payload.data());
        write_signal(Signals::length09, length09, payload.data());
        write_signal(Signals::length02, length02, payload.data());
        write_signal(Signals::length22, length22, payload.data());
        write_signal(Signals::length21, length21, payload.data());
        write_signal(Signals::length16, length16, payload.data());
        write_signal(Signals::length06, length06, payload.data());
        return payload;
    }

    static constexpr Decoded<IntelPlainShort> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Length18", "-", &IntelPlainShort::length18, &Status::length18);
        visitor("Length08", "-", &IntelPlainShort::length08, &Status::length08);
        visitor("Length03", "-", &IntelPlainShort::length03, &Status::length03);
        visitor("Length11", "-", &IntelPlainShort::length11, &Status::length11);
        visitor("Length04", "-", &IntelPlainShort::length04, &Status::length04);
        visitor("Length15", "-", &IntelPlainShort::length15, &Status::length15);
        visitor("Length05", "-", &IntelPlainShort::length05, &Status::length05);
        visitor("Length10", "-", &IntelPlainShort::length10, &Status::length10);
        visitor("Length14", "-", &IntelPlainShort::length14, &Status::length14);
        visitor("Length13", "-", &IntelPlainShort::length13, &Status::length13);
        visitor("Length17", "-", &IntelPlainShort::length17, &Status::length17);
        visitor("Length20", "-", &IntelPlainShort::length20, &Status::length20);
        visitor("Length07", "-", &IntelPlainShort::length07, &Status::length07);
        visitor("Length19", "-", &IntelPlainShort::length19, &Status::length19);
        visitor("Length12", "-", &IntelPlainShort::length12, &Status::length12);
        visitor("Length01", "-", &IntelPlainShort::length01, &Status::length01);
        visitor("Length09", "-", &IntelPlainShort::length09, &Status::length09);
        visitor("Length02", "-", &IntelPlainShort::length02, &Status::length02);
        visitor("Length22", "-", &IntelPlainShort::length22, &Status::length22);
        visitor("Length21", "-", &IntelPlainShort::length21, &Status::length21);
        visitor("Length16", "-", &IntelPlainShort::length16, &Status::length16);
        visitor("Length06", "-", &IntelPlainShort::length06, &Status::length06);
    }
};

constexpr Decoded<IntelPlainShort> IntelPlainShort::decode(const std::uint8_t* payload) {
    Decoded<IntelPlainShort> decoded{};
    read_signal(Signals::length18, payload, decoded.value.length18, decoded.status.length18);
    read_signal(Signals::length08, payload, decoded.value.length08, decoded.status.length08);
    read_signal(Signals::length03, payload, decoded.value.length03, decoded.status.length03);
    read_signal(Signals::length11, payload, decoded.value.length11, decoded.status.length11);
    read_signal(Signals::length04, payload, decoded.value.length04, decoded.status.length04);
    read_signal(Signals::length15, payload, decoded.value.length15, decoded.status.length15);
    read_signal(Signals::length05, payload, decoded.value.length05, decoded.status.length05);
    read_signal(Signals::length10, payload, decoded.value.length10, decoded.status.length10);
    read_signal(Signals::length14, payload, decoded.value.length14, decoded.status.length14);
    read_signal(Signals::length13, payload, decoded.value.length13, decoded.status.length13);
    read_signal(Signals::length17, payload, decoded.value.length17, decoded.status.length17);
    read_signal(Signals::length20, payload, decoded.value.length20, decoded.status.length20);
    read_signal(Signals::length07, payload, decoded.value.length07, decoded.status.length07);
    read_signal(Signals::length19, payload, decoded.value.length19, decoded.status.length19);
    read_signal(Signals::length12, payload, decoded.value.length12, decoded.status.length12);
    read_signal(Signals::length01, payload, decoded.value.length01, decoded.status.length01);
    read_signal(Signals::length09, payload, decoded.value.length09, decoded.status.length09);
    read_signal(Signals::length02, payload, decoded.value.length02, decoded.status.length02);
    read_signal(Signals::length22, payload, decoded.value.length22, decoded.status.length22);
    read_signal(Signals::length21, payload, decoded.value.length21, decoded.status.length21);
    read_signal(Signals::length16, payload, decoded.value.length16, decoded.status.length16);
    read_signal(Signals::length06, payload, decoded.value.length06, decoded.status.length06);
    return decoded;
}

// Test message IntelPlainLong.
// From Tester to Target, every 20 ms.
struct IntelPlainLong {
    static constexpr const char* name{"IntelPlainLong"};
    static constexpr std::uint32_t identifier{0x103U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 26 bits, unsigned, raw * 1 + 0. 0 to 67108863.
    std::uint32_t length26{0U};
    // 32 bits, unsigned, raw * 1 + 0. 0 to 4294967295.
    std::uint32_t length32{0U};
    // 31 bits, signed, raw * 1 + 0. -1073741824 to 1073741823.
    std::int32_t length31{0};
    // 30 bits, unsigned, raw * 1 + 0. 0 to 1073741823.
    std::uint32_t length30{0U};
    // 24 bits, unsigned, raw * 1 + 0. 0 to 16777215.
    std::uint32_t length24{0U};
    // 23 bits, signed, raw * 1 + 0. -4194304 to 4194303.
    std::int32_t length23{0};
    // 29 bits, signed, raw * 1 + 0. -268435456 to 268435455.
    std::int32_t length29{0};
    // 25 bits, signed, raw * 1 + 0. -16777216 to 16777215.
    std::int32_t length25{0};
    // 27 bits, signed, raw * 1 + 0. -67108864 to 67108863.
    std::int32_t length27{0};
    // 28 bits, unsigned, raw * 1 + 0. 0 to 268435455.
    std::uint32_t length28{0U};

    struct Status {
        SignalStatus length26{SignalStatus::not_available};
        SignalStatus length32{SignalStatus::not_available};
        SignalStatus length31{SignalStatus::not_available};
        SignalStatus length30{SignalStatus::not_available};
        SignalStatus length24{SignalStatus::not_available};
        SignalStatus length23{SignalStatus::not_available};
        SignalStatus length29{SignalStatus::not_available};
        SignalStatus length25{SignalStatus::not_available};
        SignalStatus length27{SignalStatus::not_available};
        SignalStatus length28{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return length26 == SignalStatus::valid &&
                   length32 == SignalStatus::valid &&
                   length31 == SignalStatus::valid &&
                   length30 == SignalStatus::valid &&
                   length24 == SignalStatus::valid &&
                   length23 == SignalStatus::valid &&
                   length29 == SignalStatus::valid &&
                   length25 == SignalStatus::valid &&
                   length27 == SignalStatus::valid &&
                   length28 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr IntegerSignal length26{
            {ByteOrder::little_endian, 3U, 26U, false}, 0, 67108863, 0};
        static constexpr IntegerSignal length32{
            {ByteOrder::little_endian, 29U, 32U, false}, 0, 4294967295LL, 0};
        static constexpr IntegerSignal length31{
            {ByteOrder::little_endian, 61U, 31U, true}, -1073741824, 1073741823, 0};
        static constexpr IntegerSignal length30{
            {ByteOrder::little_endian, 94U, 30U, false}, 0, 1073741823, 0};
        static constexpr IntegerSignal length24{
            {ByteOrder::little_endian, 124U, 24U, false}, 0, 16777215, 0};
        static constexpr IntegerSignal length23{
            {ByteOrder::little_endian, 148U, 23U, true}, -4194304, 4194303, 0};
        static constexpr IntegerSignal length29{
            {ByteOrder::little_endian, 172U, 29U, true}, -268435456, 268435455, 0};
        static constexpr IntegerSignal length25{
            {ByteOrder::little_endian, 202U, 25U, true}, -16777216, 16777215, 0};
        static constexpr IntegerSignal length27{
            {ByteOrder::little_endian, 229U, 27U, true}, -67108864, 67108863, 0};
        static constexpr IntegerSignal length28{
            {ByteOrder::little_endian, 258U, 28U, false}, 0, 268435455, 0};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::length26, length26, payload.data());
        write_signal(Signals::length32, length32, payload.data());
        write_signal(Signals::length31, length31, payload.data());
        write_signal(Signals::length30, length30, payload.data());
        write_signal(Signals::length24, length24, payload.data());
        write_signal(Signals::length23, length23, payload.data());
        write_signal(Signals::length29, length29, payload.data());
        write_signal(Signals::length25, length25, payload.data());
        write_signal(Signals::length27, length27, payload.data());
        write_signal(Signals::length28, length28, payload.data());
        return payload;
    }

    static constexpr Decoded<IntelPlainLong> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Length26", "-", &IntelPlainLong::length26, &Status::length26);
        visitor("Length32", "-", &IntelPlainLong::length32, &Status::length32);
        visitor("Length31", "-", &IntelPlainLong::length31, &Status::length31);
        visitor("Length30", "-", &IntelPlainLong::length30, &Status::length30);
        visitor("Length24", "-", &IntelPlainLong::length24, &Status::length24);
        visitor("Length23", "-", &IntelPlainLong::length23, &Status::length23);
        visitor("Length29", "-", &IntelPlainLong::length29, &Status::length29);
        visitor("Length25", "-", &IntelPlainLong::length25, &Status::length25);
        visitor("Length27", "-", &IntelPlainLong::length27, &Status::length27);
        visitor("Length28", "-", &IntelPlainLong::length28, &Status::length28);
    }
};

constexpr Decoded<IntelPlainLong> IntelPlainLong::decode(const std::uint8_t* payload) {
    Decoded<IntelPlainLong> decoded{};
    read_signal(Signals::length26, payload, decoded.value.length26, decoded.status.length26);
    read_signal(Signals::length32, payload, decoded.value.length32, decoded.status.length32);
    read_signal(Signals::length31, payload, decoded.value.length31, decoded.status.length31);
    read_signal(Signals::length30, payload, decoded.value.length30, decoded.status.length30);
    read_signal(Signals::length24, payload, decoded.value.length24, decoded.status.length24);
    read_signal(Signals::length23, payload, decoded.value.length23, decoded.status.length23);
    read_signal(Signals::length29, payload, decoded.value.length29, decoded.status.length29);
    read_signal(Signals::length25, payload, decoded.value.length25, decoded.status.length25);
    read_signal(Signals::length27, payload, decoded.value.length27, decoded.status.length27);
    read_signal(Signals::length28, payload, decoded.value.length28, decoded.status.length28);
    return decoded;
}

// Test message MotorolaScaledShort.
// From Tester to Target, every 20 ms.
struct MotorolaScaledShort {
    static constexpr const char* name{"MotorolaScaledShort"};
    static constexpr std::uint32_t identifier{0x104U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 8 bits, unsigned, raw * 50 + 0. Dimensionless, 0 to 12300.
    float length08{not_available};
    // 19 bits, signed, raw * 0.00390625 + 0. Dimensionless, -1023.921 to 1023.996.
    float length19{not_available};
    // 6 bits, unsigned, raw * 7 + -3.5. Dimensionless, 3.5 to 430.5.
    float length06{10.5F};
    // 4 bits, unsigned, raw * -0.5 + 3. Dimensionless, -4 to 2.5.
    float length04{2.0F};
    // 1 bits, signed, raw * 1 + 0. -1 to 0.
    std::int8_t length01{0};
    // 14 bits, unsigned, raw * -0.5 + 3. Dimensionless, -8181 to 3.
    float length14{not_available};
    // 9 bits, signed, raw * 0.00390625 + 0. Dimensionless, -0.996 to 0.992.
    float length09{0.0078125F};
    // 15 bits, signed, raw * 0.002 + 0. Dimensionless, -32.766 to 32.764.
    float length15{0.004F};
    // 13 bits, signed, raw * -0.01 + 0.3. Dimensionless, -40.65 to 41.12.
    float length13{not_available};
    // 20 bits, unsigned, raw * 1 + 0. Dimensionless, 0 to 1048554.
    float length20{not_available};
    // 17 bits, signed, raw * 0.25 + -10. Dimensionless, -16389.5 to 16373.75.
    float length17{not_available};
    // 18 bits, unsigned, raw * 50 + 0. Dimensionless, 50 to 13107100.
    float length18{100.0F};
    // 3 bits, signed, raw * 1 + 0. -4 to 3.
    std::int8_t length03{0};
    // 10 bits, unsigned, raw * 1 + 0. Dimensionless, 0 to 1012.
    float length10{not_available};
    // 12 bits, unsigned, raw * 0.0174532925 + 0. Dimensionless, 0.018 to 71.453.
    float length12{0.034906585F};
    // 5 bits, signed, raw * 0.002 + 0. Dimensionless, -0.03 to 0.028.
    float length05{0.004F};
    // 7 bits, signed, raw * 0.25 + -10. Dimensionless, -24 to 5.75.
    float length07{not_available};
    // 11 bits, signed, raw * 0.1 + -40. Dimensionless, -141.2 to 62.3.
    float length11{not_available};
    // 16 bits, unsigned, raw * 7 + -3.5. Dimensionless, -3.5 to 458622.5.
    float length16{not_available};
    // 22 bits, unsigned, raw * 0.0174532925 + 0. Dimensionless, 0 to 73203.995.
    float length22{not_available};
    // 21 bits, signed, raw * 0.1 + -40. Dimensionless, -104897.5 to 104817.4.
    float length21{-39.8F};
    // 2 bits, unsigned, raw * 1 + 0. 0 to 3.
    std::uint8_t length02{0U};

    struct Status {
        SignalStatus length08{SignalStatus::not_available};
        SignalStatus length19{SignalStatus::not_available};
        SignalStatus length06{SignalStatus::not_available};
        SignalStatus length04{SignalStatus::not_available};
        SignalStatus length01{SignalStatus::not_available};
        SignalStatus length14{SignalStatus::not_available};
        SignalStatus length09{SignalStatus::not_available};
        SignalStatus length15{SignalStatus::not_available};
        SignalStatus length13{SignalStatus::not_available};
        SignalStatus length20{SignalStatus::not_available};
        SignalStatus length17{SignalStatus::not_available};
        SignalStatus length18{SignalStatus::not_available};
        SignalStatus length03{SignalStatus::not_available};
        SignalStatus length10{SignalStatus::not_available};
        SignalStatus length12{SignalStatus::not_available};
        SignalStatus length05{SignalStatus::not_available};
        SignalStatus length07{SignalStatus::not_available};
        SignalStatus length11{SignalStatus::not_available};
        SignalStatus length16{SignalStatus::not_available};
        SignalStatus length22{SignalStatus::not_available};
        SignalStatus length21{SignalStatus::not_available};
        SignalStatus length02{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return length08 == SignalStatus::valid &&
                   length19 == SignalStatus::valid &&
                   length06 == SignalStatus::valid &&
                   length04 == SignalStatus::valid &&
                   length01 == SignalStatus::valid &&
                   length14 == SignalStatus::valid &&
                   length09 == SignalStatus::valid &&
                   length15 == SignalStatus::valid &&
                   length13 == SignalStatus::valid &&
                   length20 == SignalStatus::valid &&
                   length17 == SignalStatus::valid &&
                   length18 == SignalStatus::valid &&
                   length03 == SignalStatus::valid &&
                   length10 == SignalStatus::valid &&
                   length12 == SignalStatus::valid &&
                   length05 == SignalStatus::valid &&
                   length07 == SignalStatus::valid &&
                   length11 == SignalStatus::valid &&
                   length16 == SignalStatus::valid &&
                   length22 == SignalStatus::valid &&
                   length21 == SignalStatus::valid &&
                   length02 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> length08{
            {ByteOrder::big_endian, 4U, 8U, false}, 50.0F, 0.0F, 1.0F, 0.0F, 12300.0F,
            0, 246, 255, true};
        static constexpr PhysicalSignal<std::int32_t> length19{
            {ByteOrder::big_endian, 10U, 19U, true}, 1.0F, 0.0F, 256.0F, -1023.921F, 1023.996F,
            -262123, 262142, -262144, true};
        static constexpr PhysicalSignal<std::int32_t> length06{
            {ByteOrder::big_endian, 39U, 6U, false}, 14.0F, -7.0F, 2.0F, 3.5F, 430.5F,
            1, 62, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length04{
            {ByteOrder::big_endian, 47U, 4U, false}, -1.0F, 6.0F, 2.0F, -4.0F, 2.5F,
            14, 1, 2, false};
        static constexpr IntegerSignal length01{
            {ByteOrder::big_endian, 41U, 1U, true}, -1, 0, 0};
        static constexpr PhysicalSignal<std::int32_t> length14{
            {ByteOrder::big_endian, 55U, 14U, false}, -1.0F, 6.0F, 2.0F, -8181.0F, 3.0F,
            16368, 0, 16383, true};
        static constexpr PhysicalSignal<std::int32_t> length09{
            {ByteOrder::big_endian, 71U, 9U, true}, 1.0F, 0.0F, 256.0F, -0.996F, 0.992F,
            -254, 253, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length15{
            {ByteOrder::big_endian, 77U, 15U, true}, 1.0F, 0.0F, 500.0F, -32.766F, 32.764F,
            -16383, 16382, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length13{
            {ByteOrder::big_endian, 93U, 13U, true}, -1.0F, 30.0F, 100.0F, -40.65F, 41.12F,
            4095, -4082, -4096, true};
        static constexpr PhysicalSignal<std::int32_t> length20{
            {ByteOrder::big_endian, 110U, 20U, false}, 1.0F, 0.0F, 1.0F, 0.0F, 1048554.0F,
            0, 1048554, 1048575, true};
        static constexpr PhysicalSignal<std::int32_t> length17{
            {ByteOrder::big_endian, 120U, 17U, true}, 1.0F, -40.0F, 4.0F, -16389.5F, 16373.75F,
            -65518, 65535, -65536, true};
        static constexpr PhysicalSignal<std::int32_t> length18{
            {ByteOrder::big_endian, 151U, 18U, false}, 50.0F, 0.0F, 1.0F, 50.0F, 13107100.0F,
            1, 262142, 2, false};
        static constexpr IntegerSignal length03{
            {ByteOrder::big_endian, 165U, 3U, true}, -4, 3, 0};
        static constexpr PhysicalSignal<std::int32_t> length10{
            {ByteOrder::big_endian, 160U, 10U, false}, 1.0F, 0.0F, 1.0F, 0.0F, 1012.0F,
            0, 1012, 1023, true};
        static constexpr PhysicalSignal<std::int32_t> length12{
            {ByteOrder::big_endian, 182U, 12U, false}, 6981317.0F, 0.0F, 400000000.0F, 0.018F, 71.453F,
            2, 4093, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length05{
            {ByteOrder::big_endian, 184U, 5U, true}, 1.0F, 0.0F, 500.0F, -0.03F, 0.028F,
            -15, 14, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length07{
            {ByteOrder::big_endian, 194U, 7U, true}, 1.0F, -40.0F, 4.0F, -24.0F, 5.75F,
            -56, 63, -64, true};
        static constexpr PhysicalSignal<std::int32_t> length11{
            {ByteOrder::big_endian, 203U, 11U, true}, 1.0F, -400.0F, 10.0F, -141.2F, 62.3F,
            -1012, 1023, -1024, true};
        static constexpr PhysicalSignal<std::int32_t> length16{
            {ByteOrder::big_endian, 208U, 16U, false}, 14.0F, -7.0F, 2.0F, -3.5F, 458622.5F,
            0, 65518, 65535, true};
        static constexpr PhysicalSignal<std::int32_t> length22{
            {ByteOrder::big_endian, 238U, 22U, false}, 6981317.0F, 0.0F, 400000000.0F, 0.0F, 73203.995F,
            0, 4194279, 4194303, true};
        static constexpr PhysicalSignal<std::int32_t> length21{
            {ByteOrder::big_endian, 263U, 21U, true}, 1.0F, -400.0F, 10.0F, -104897.5F, 104817.4F,
            -1048575, 1048574, 2, false};
        static constexpr IntegerSignal length02{
            {ByteOrder::big_endian, 273U, 2U, false}, 0, 3, 0};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::length08, length08, payload.data());
        write_signal(Signals::length19, length19, payload.data());
        write_signal(Signals::length06, length06, payload.data());
        write_signal(Signals::length04, length04, payload.data());
        write_signal(Signals::length01, length01, payload.data());
        write_signal(Signals::length14, length14, payload.data());
        write_signal(Signals::length09, length09, payload.data());
        write_signal(Signals::length15, length15, payload.data());
        write_signal(Signals::length13, length13, payload.data());
        write_signal(Signals::length20, length20, payload.data());
        write_signal(Signals::length17, length17, payload.data());
        write_signal(Signals::length18, length18, payload.data());
        write_signal(Signals::length03, length03, payload.data());
        write_signal(Signals::length10, length10, payload.data());
        write_signal(Signals::length12, length12, payload.data());
        write_signal(Signals::length05, length05, payload.data());
        write_signal(Signals::length07, length07, payload.data());
        write_signal(Signals::length11, length11, payload.data());
        write_signal(Signals::length16, length16, payload.data());
        write_signal(Signals::length22, length22, payload.data());
        write_signal(Signals::length21, length21, payload.data());
        write_signal(Signals::length02, length02, payload.data());
        return payload;
    }

    static constexpr Decoded<MotorolaScaledShort> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Length08", "-", &MotorolaScaledShort::length08, &Status::length08);
        visitor("Length19", "-", &MotorolaScaledShort::length19, &Status::length19);
        visitor("Length06", "-", &MotorolaScaledShort::length06, &Status::length06);
        visitor("Length04", "-", &MotorolaScaledShort::length04, &Status::length04);
        visitor("Length01", "-", &MotorolaScaledShort::length01, &Status::length01);
        visitor("Length14", "-", &MotorolaScaledShort::length14, &Status::length14);
        visitor("Length09", "-", &MotorolaScaledShort::length09, &Status::length09);
        visitor("Length15", "-", &MotorolaScaledShort::length15, &Status::length15);
        visitor("Length13", "-", &MotorolaScaledShort::length13, &Status::length13);
        visitor("Length20", "-", &MotorolaScaledShort::length20, &Status::length20);
        visitor("Length17", "-", &MotorolaScaledShort::length17, &Status::length17);
        visitor("Length18", "-", &MotorolaScaledShort::length18, &Status::length18);
        visitor("Length03", "-", &MotorolaScaledShort::length03, &Status::length03);
        visitor("Length10", "-", &MotorolaScaledShort::length10, &Status::length10);
        visitor("Length12", "-", &MotorolaScaledShort::length12, &Status::length12);
        visitor("Length05", "-", &MotorolaScaledShort::length05, &Status::length05);
        visitor("Length07", "-", &MotorolaScaledShort::length07, &Status::length07);
        visitor("Length11", "-", &MotorolaScaledShort::length11, &Status::length11);
        visitor("Length16", "-", &MotorolaScaledShort::length16, &Status::length16);
        visitor("Length22", "-", &MotorolaScaledShort::length22, &Status::length22);
        visitor("Length21", "-", &MotorolaScaledShort::length21, &Status::length21);
        visitor("Length02", "-", &MotorolaScaledShort::length02, &Status::length02);
    }
};

constexpr Decoded<MotorolaScaledShort> MotorolaScaledShort::decode(const std::uint8_t* payload) {
    Decoded<MotorolaScaledShort> decoded{};
    read_signal(Signals::length08, payload, decoded.value.length08, decoded.status.length08);
    read_signal(Signals::length19, payload, decoded.value.length19, decoded.status.length19);
    read_signal(Signals::length06, payload, decoded.value.length06, decoded.status.length06);
    read_signal(Signals::length04, payload, decoded.value.length04, decoded.status.length04);
    read_signal(Signals::length01, payload, decoded.value.length01, decoded.status.length01);
    read_signal(Signals::length14, payload, decoded.value.length14, decoded.status.length14);
    read_signal(Signals::length09, payload, decoded.value.length09, decoded.status.length09);
    read_signal(Signals::length15, payload, decoded.value.length15, decoded.status.length15);
    read_signal(Signals::length13, payload, decoded.value.length13, decoded.status.length13);
    read_signal(Signals::length20, payload, decoded.value.length20, decoded.status.length20);
    read_signal(Signals::length17, payload, decoded.value.length17, decoded.status.length17);
    read_signal(Signals::length18, payload, decoded.value.length18, decoded.status.length18);
    read_signal(Signals::length03, payload, decoded.value.length03, decoded.status.length03);
    read_signal(Signals::length10, payload, decoded.value.length10, decoded.status.length10);
    read_signal(Signals::length12, payload, decoded.value.length12, decoded.status.length12);
    read_signal(Signals::length05, payload, decoded.value.length05, decoded.status.length05);
    read_signal(Signals::length07, payload, decoded.value.length07, decoded.status.length07);
    read_signal(Signals::length11, payload, decoded.value.length11, decoded.status.length11);
    read_signal(Signals::length16, payload, decoded.value.length16, decoded.status.length16);
    read_signal(Signals::length22, payload, decoded.value.length22, decoded.status.length22);
    read_signal(Signals::length21, payload, decoded.value.length21, decoded.status.length21);
    read_signal(Signals::length02, payload, decoded.value.length02, decoded.status.length02);
    return decoded;
}

// Test message MotorolaScaledLong.
// From Tester to Target, every 20 ms.
struct MotorolaScaledLong {
    static constexpr const char* name{"MotorolaScaledLong"};
    static constexpr std::uint32_t identifier{0x105U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 31 bits, signed, raw * 0.1 + -40. Dimensionless, -107374222.3 to 107374142.2.
    float length31{-39.8F};
    // 32 bits, unsigned, raw * 0.0174532925 + 0. Dimensionless, 0.018 to 74961320.46.
    float length32{0.034906585F};
    // 24 bits, unsigned, raw * -0.5 + 3. Dimensionless, -8388604 to 2.5.
    float length24{2.0F};
    // 26 bits, unsigned, raw * 7 + -3.5. Dimensionless, 3.5 to 469762030.5.
    float length26{10.5F};
    // 29 bits, signed, raw * 0.00390625 + 0. Dimensionless, -1048575.996 to 1048575.992.
    float length29{0.0078125F};
    // 30 bits, unsigned, raw * 1 + 0. 1 to 1073741822.
    std::uint32_t length30{2U};
    // 25 bits, signed, raw * 0.002 + 0. Dimensionless, -33554.43 to 33554.428.
    float length25{0.004F};
    // 27 bits, signed, raw * 0.25 + -10. Dimensionless, -16777225.75 to 16777205.5.
    float length27{-9.5F};
    // 23 bits, signed, raw * -0.01 + 0.3. Dimensionless, -41942.73 to 41943.1.
    float length23{not_available};
    // 28 bits, unsigned, raw * 50 + 0. Dimensionless, 50 to 13421772700.
    float length28{100.0F};

    struct Status {
        SignalStatus length31{SignalStatus::not_available};
        SignalStatus length32{SignalStatus::not_available};
        SignalStatus length24{SignalStatus::not_available};
        SignalStatus length26{SignalStatus::not_available};
        SignalStatus length29{SignalStatus::not_available};
        SignalStatus length30{SignalStatus::not_available};
        SignalStatus length25{SignalStatus::not_available};
        SignalStatus length27{SignalStatus::not_available};
        SignalStatus length23{SignalStatus::not_available};
        SignalStatus length28{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return length31 == SignalStatus::valid &&
                   length32 == SignalStatus::valid &&
                   length24 == SignalStatus::valid &&
                   length26 == SignalStatus::valid &&
                   length29 == SignalStatus::valid &&
                   length30 == SignalStatus::valid &&
                   length25 == SignalStatus::valid &&
                   length27 == SignalStatus::valid &&
                   length23 == SignalStatus::valid &&
                   length28 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int64_t> length31{
            {ByteOrder::big_endian, 4U, 31U, true}, 1.0F, -400.0F, 10.0F, -107374222.3F, 107374142.2F,
            -1073741823, 1073741822, 2, false};
        static constexpr PhysicalSignal<std::int64_t> length32{
            {ByteOrder::big_endian, 36U, 32U, false}, 6981317.0F, 0.0F, 400000000.0F, 0.018F, 74961320.46F,
            2, 4294967293LL, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length24{
            {ByteOrder::big_endian, 68U, 24U, false}, -1.0F, 6.0F, 2.0F, -8388604.0F, 2.5F,
            16777214, 1, 2, false};
        static constexpr PhysicalSignal<std::int64_t> length26{
            {ByteOrder::big_endian, 92U, 26U, false}, 14.0F, -7.0F, 2.0F, 3.5F, 469762030.5F,
            1, 67108862, 2, false};
        static constexpr PhysicalSignal<std::int64_t> length29{
            {ByteOrder::big_endian, 112U, 29U, true}, 1.0F, 0.0F, 256.0F, -1048575.996F, 1048575.992F,
            -268435454, 268435453, 2, false};
        static constexpr IntegerSignal length30{
            {ByteOrder::big_endian, 146U, 30U, false}, 1, 1073741822, 2};
        static constexpr PhysicalSignal<std::int64_t> length25{
            {ByteOrder::big_endian, 179U, 25U, true}, 1.0F, 0.0F, 500.0F, -33554.43F, 33554.428F,
            -16777215, 16777214, 2, false};
        static constexpr PhysicalSignal<std::int64_t> length27{
            {ByteOrder::big_endian, 201U, 27U, true}, 1.0F, -40.0F, 4.0F, -16777225.75F, 16777205.5F,
            -67108863, 67108862, 2, false};
        static constexpr PhysicalSignal<std::int32_t> length23{
            {ByteOrder::big_endian, 236U, 23U, true}, -1.0F, 30.0F, 100.0F, -41942.73F, 41943.1F,
            4194303, -4194280, -4194304, true};
        static constexpr PhysicalSignal<std::int64_t> length28{
            {ByteOrder::big_endian, 260U, 28U, false}, 50.0F, 0.0F, 1.0F, 50.0F, 13421772700.0F,
            1, 268435454, 2, false};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::length31, length31, payload.data());
        write_signal(Signals::length32, length32, payload.data());
        write_signal(Signals::length24, length24, payload.data());
        write_signal(Signals::length26, length26, payload.data());
        write_signal(Signals::length29, length29, payload.data());
        write_signal(Signals::length30, length30, payload.data());
        write_signal(Signals::length25, length25, payload.data());
        write_signal(Signals::length27, length27, payload.data());
        write_signal(Signals::length23, length23, payload.data());
        write_signal(Signals::length28, length28, payload.data());
        return payload;
    }

    static constexpr Decoded<MotorolaScaledLong> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Length31", "-", &MotorolaScaledLong::length31, &Status::length31);
        visitor("Length32", "-", &MotorolaScaledLong::length32, &Status::length32);
        visitor("Length24", "-", &MotorolaScaledLong::length24, &Status::length24);
        visitor("Length26", "-", &MotorolaScaledLong::length26, &Status::length26);
        visitor("Length29", "-", &MotorolaScaledLong::length29, &Status::length29);
        visitor("Length30", "-", &MotorolaScaledLong::length30, &Status::length30);
        visitor("Length25", "-", &MotorolaScaledLong::length25, &Status::length25);
        visitor("Length27", "-", &MotorolaScaledLong::length27, &Status::length27);
        visitor("Length23", "-", &MotorolaScaledLong::length23, &Status::length23);
        visitor("Length28", "-", &MotorolaScaledLong::length28, &Status::length28);
    }
};

constexpr Decoded<MotorolaScaledLong> MotorolaScaledLong::decode(const std::uint8_t* payload) {
    Decoded<MotorolaScaledLong> decoded{};
    read_signal(Signals::length31, payload, decoded.value.length31, decoded.status.length31);
    read_signal(Signals::length32, payload, decoded.value.length32, decoded.status.length32);
    read_signal(Signals::length24, payload, decoded.value.length24, decoded.status.length24);
    read_signal(Signals::length26, payload, decoded.value.length26, decoded.status.length26);
    read_signal(Signals::length29, payload, decoded.value.length29, decoded.status.length29);
    read_signal(Signals::length30, payload, decoded.value.length30, decoded.status.length30);
    read_signal(Signals::length25, payload, decoded.value.length25, decoded.status.length25);
    read_signal(Signals::length27, payload, decoded.value.length27, decoded.status.length27);
    read_signal(Signals::length23, payload, decoded.value.length23, decoded.status.length23);
    read_signal(Signals::length28, payload, decoded.value.length28, decoded.status.length28);
    return decoded;
}

// Test message MotorolaPlainShort.
// From Tester to Target, every 20 ms.
struct MotorolaPlainShort {
    static constexpr const char* name{"MotorolaPlainShort"};
    static constexpr std::uint32_t identifier{0x106U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 8 bits, signed, raw * 1 + 0. -128 to 127.
    std::int8_t length08{0};
    // 2 bits, signed, raw * 1 + 0. -2 to 1.
    std::int8_t length02{0};
    // 5 bits, unsigned, raw * 1 + 0. 0 to 31.
    std::uint8_t length05{0U};
    // 1 bits, unsigned, raw * 1 + 0.
    bool length01{false};
    // 10 bits, signed, raw * 1 + 0. -512 to 511.
    std::int16_t length10{0};
    // 11 bits, unsigned, raw * 1 + 0. 0 to 2047.
    std::uint16_t length11{0U};
    // 7 bits, unsigned, raw * 1 + 0. 0 to 127.
    std::uint8_t length07{0U};
    // 19 bits, unsigned, raw * 1 + 0. 0 to 524287.
    std::uint32_t length19{0U};
    // 4 bits, signed, raw * 1 + 0. -8 to 7.
    std::int8_t length04{0};
    // 18 bits, signed, raw * 1 + 0. -131072 to 131071.
    std::int32_t length18{0};
    // 13 bits, unsigned, raw * 1 + 0. 0 to 8191.
    std::uint16_t length13{0U};
    // 3 bits, unsigned, raw * 1 + 0. 0 to 7.
    std::uint8_t length03{0U};
    // 21 bits, unsigned, raw * 1 + 0. 0 to 2097151.
    std::uint32_t length21{0U};
    // 16 bits, signed, raw * 1 + 0. -32768 to 32767.
    std::int16_t length16{0};
    // 17 bits, unsigned, raw * 1 + 0. 0 to 131071.
    std::uint32_t length17{0U};
    // 15 bits, unsigned, raw * 1 + 0. 0 to 32767.
    std::uint16_t length15{0U};
    // 6 bits, signed, raw * 1 + 0. -32 to 31.
    std::int8_t length06{0};
    // 20 bits, signed, raw * 1 + 0. -524288 to 524287.
    std::int32_t length20{0};
    // 14 bits, signed, raw * 1 + 0. -8192 to 8191.
    std::int16_t length14{0};
    // 22 bits, signed, raw * 1 + 0. -2097152 to 2097151.
    std::int32_t length22{0};
    // 9 bits, unsigned, raw * 1 + 0. 0 to 511.
    std::uint16_t length09{0U};
    // 12 bits, signed, raw * 1 + 0. -2048 to 2047.
    std::int16_t length12{0};

    struct Status {
        SignalStatus length08{SignalStatus::not_available};
        SignalStatus length02{SignalStatus::not_available};
        SignalStatus length05{SignalStatus::not_available};
        SignalStatus length01{SignalStatus::not_available};
        SignalStatus length10{SignalStatus::not_available};
        SignalStatus length11{SignalStatus::not_available};
        SignalStatus length07{SignalStatus::not_available};
        SignalStatus length19{SignalStatus::not_available};
        SignalStatus length04{SignalStatus::not_available};
        SignalStatus length18{SignalStatus::not_available};
        SignalStatus length13{SignalStatus::not_available};
        SignalStatus length03{SignalStatus::not_available};
        SignalStatus length21{SignalStatus::not_available};
        SignalStatus length16{SignalStatus::not_available};
        SignalStatus length17{SignalStatus::not_available};
        SignalStatus length15{SignalStatus::not_available};
        SignalStatus length06{SignalStatus::not_available};
        SignalStatus length20{SignalStatus::not_available};
        SignalStatus length14{SignalStatus::not_available};
        SignalStatus length22{SignalStatus::not_available};
        SignalStatus length09{SignalStatus::not_available};
        SignalStatus length12{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return length08 == SignalStatus::valid &&
                   length02 == SignalStatus::valid &&
                   length05 == SignalStatus::valid &&
                   length01 == SignalStatus::valid &&
                   length10 == SignalStatus::valid &&
                   length11 == SignalStatus::valid &&
                   length07 == SignalStatus::valid &&
                   length19 == SignalStatus::valid &&
                   length04 == SignalStatus::valid &&
                   length18 == SignalStatus::valid &&
                   length13 == SignalStatus::valid &&
                   length03 == SignalStatus::valid &&
                   length21 == SignalStatus::valid &&
                   length16 == SignalStatus::valid &&
                   length17 == SignalStatus::valid &&
                   length15 == SignalStatus::valid &&
                   length06 == SignalStatus::valid &&
                   length20 == SignalStatus::valid &&
                   length14 == SignalStatus::valid &&
                   length22 == SignalStatus::valid &&
                   length09 == SignalStatus::valid &&
                   length12 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr IntegerSignal length08{
            {ByteOrder::big_endian, 4U, 8U, true}, -128, 127, 0};
        static constexpr IntegerSignal length02{
            {ByteOrder::big_endian, 12U, 2U, true}, -2, 1, 0};
        static constexpr IntegerSignal length05{
            {ByteOrder::big_endian, 8U, 5U, false}, 0, 31, 0};
        static constexpr IntegerSignal length01{
            {ByteOrder::big_endian, 18U, 1U, false}, 0, 1, 0};
        static constexpr IntegerSignal length10{
            {ByteOrder::big_endian, 16U, 10U, true}, -512, 511, 0};
        static constexpr IntegerSignal length11{
            {ByteOrder::big_endian, 38U, 11U, false}, 0, 2047, 0};
        static constexpr IntegerSignal length07{
            {ByteOrder::big_endian, 43U, 7U, false}, 0, 127, 0};
        static constexpr IntegerSignal length19{
            {ByteOrder::big_endian, 52U, 19U, false}, 0, 524287, 0};
        static constexpr IntegerSignal length04{
            {ByteOrder::big_endian, 79U, 4U, true}, -8, 7, 0};
        static constexpr IntegerSignal length18{
            {ByteOrder::big_endian, 75U, 18U, true}, -131072, 131071, 0};
        static constexpr IntegerSignal length13{
            {ByteOrder::big_endian, 89U, 13U, false}, 0, 8191, 0};
        static constexpr IntegerSignal length03{
            {ByteOrder::big_endian, 108U, 3U, false}, 0, 7, 0};
        static constexpr IntegerSignal length21{
            {ByteOrder::big_endian, 105U, 21U, false}, 0, 2097151, 0};
        static constexpr IntegerSignal length16{
            {ByteOrder::big_endian, 130U, 16U, true}, -32768, 32767, 0};
        static constexpr IntegerSignal length17{
            {ByteOrder::big_endian, 146U, 17U, false}, 0, 131071, 0};
        static constexpr IntegerSignal length15{
            {ByteOrder::big_endian, 161U, 15U, false}, 0, 32767, 0};
        static constexpr IntegerSignal length06{
            {ByteOrder::big_endian, 178U, 6U, true}, -32, 31, 0};
        static constexpr IntegerSignal length20{
            {ByteOrder::big_endian, 188U, 20U, true}, -524288, 524287, 0};
        static constexpr IntegerSignal length14{
            {ByteOrder::big_endian, 200U, 14U, true}, -8192, 8191, 0};
        static constexpr IntegerSignal length22{
            {ByteOrder::big_endian, 217U, 22U, true}, -2097152, 2097151, 0};
        static constexpr IntegerSignal length09{
            {ByteOrder::big_endian, 243U, 9U, false}, 0, 511, 0};
        static constexpr IntegerSignal length12{
            {ByteOrder::big_endian, 248U, 12U, true}, -2048, 2047, 0};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::length08, length08, payload.data());
        write_signal(Signals::length02, length02, payload.data());
        write_signal(Signals::length05, length05, payload.data());
        write_signal(Signals::length01, length01, payload.data());
        write_signal(Signals::length10, length10, payload.data());
        write_signal(Signals::length11, length11, payload.data());
        write_signal(Signals::length07, length07, payload.data());
        write_signal(Signals::length19, length19, payload.data());
        write_signal(Signals::length04, length04, payload.data());
        write_signal(Signals::length18, length18, payload.data());
        write_signal(Signals::length13, length13, payload.data());
        write_signal(Signals::length03, length03, payload.data());
        write_signal(Signals::length21, length21, payload.data());
        write_signal(Signals::length16, length16, payload.data());
        write_signal(Signals::length17, length17, payload.data());
        write_signal(Signals::length15, length15, payload.data());
        write_signal(Signals::length06, length06, payload.data());
        write_signal(Signals::length20, length20, payload.data());
        write_signal(Signals::length14, length14, payload.data());
        write_signal(Signals::length22, length22, payload.data());
        write_signal(Signals::length09, length09, payload.data());
        write_signal(Signals::length12, length12, payload.data());
        return payload;
    }

    static constexpr Decoded<MotorolaPlainShort> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Length08", "-", &MotorolaPlainShort::length08, &Status::length08);
        visitor("Length02", "-", &MotorolaPlainShort::length02, &Status::length02);
        visitor("Length05", "-", &MotorolaPlainShort::length05, &Status::length05);
        visitor("Length01", "-", &MotorolaPlainShort::length01, &Status::length01);
        visitor("Length10", "-", &MotorolaPlainShort::length10, &Status::length10);
        visitor("Length11", "-", &MotorolaPlainShort::length11, &Status::length11);
        visitor("Length07", "-", &MotorolaPlainShort::length07, &Status::length07);
        visitor("Length19", "-", &MotorolaPlainShort::length19, &Status::length19);
        visitor("Length04", "-", &MotorolaPlainShort::length04, &Status::length04);
        visitor("Length18", "-", &MotorolaPlainShort::length18, &Status::length18);
        visitor("Length13", "-", &MotorolaPlainShort::length13, &Status::length13);
        visitor("Length03", "-", &MotorolaPlainShort::length03, &Status::length03);
        visitor("Length21", "-", &MotorolaPlainShort::length21, &Status::length21);
        visitor("Length16", "-", &MotorolaPlainShort::length16, &Status::length16);
        visitor("Length17", "-", &MotorolaPlainShort::length17, &Status::length17);
        visitor("Length15", "-", &MotorolaPlainShort::length15, &Status::length15);
        visitor("Length06", "-", &MotorolaPlainShort::length06, &Status::length06);
        visitor("Length20", "-", &MotorolaPlainShort::length20, &Status::length20);
        visitor("Length14", "-", &MotorolaPlainShort::length14, &Status::length14);
        visitor("Length22", "-", &MotorolaPlainShort::length22, &Status::length22);
        visitor("Length09", "-", &MotorolaPlainShort::length09, &Status::length09);
        visitor("Length12", "-", &MotorolaPlainShort::length12, &Status::length12);
    }
};

constexpr Decoded<MotorolaPlainShort> MotorolaPlainShort::decode(const std::uint8_t* payload) {
    Decoded<MotorolaPlainShort> decoded{};
    read_signal(Signals::length08, payload, decoded.value.length08, decoded.status.length08);
    read_signal(Signals::length02, payload, decoded.value.length02, decoded.status.length02);
    read_signal(Signals::length05, payload, decoded.value.length05, decoded.status.length05);
    read_signal(Signals::length01, payload, decoded.value.length01, decoded.status.length01);
    read_signal(Signals::length10, payload, decoded.value.length10, decoded.status.length10);
    read_signal(Signals::length11, payload, decoded.value.length11, decoded.status.length11);
    read_signal(Signals::length07, payload, decoded.value.length07, decoded.status.length07);
    read_signal(Signals::length19, payload, decoded.value.length19, decoded.status.length19);
    read_signal(Signals::length04, payload, decoded.value.length04, decoded.status.length04);
    read_signal(Signals::length18, payload, decoded.value.length18, decoded.status.length18);
    read_signal(Signals::length13, payload, decoded.value.length13, decoded.status.length13);
    read_signal(Signals::length03, payload, decoded.value.length03, decoded.status.length03);
    read_signal(Signals::length21, payload, decoded.value.length21, decoded.status.length21);
    read_signal(Signals::length16, payload, decoded.value.length16, decoded.status.length16);
    read_signal(Signals::length17, payload, decoded.value.length17, decoded.status.length17);
    read_signal(Signals::length15, payload, decoded.value.length15, decoded.status.length15);
    read_signal(Signals::length06, payload, decoded.value.length06, decoded.status.length06);
    read_signal(Signals::length20, payload, decoded.value.length20, decoded.status.length20);
    read_signal(Signals::length14, payload, decoded.value.length14, decoded.status.length14);
    read_signal(Signals::length22, payload, decoded.value.length22, decoded.status.length22);
    read_signal(Signals::length09, payload, decoded.value.length09, decoded.status.length09);
    read_signal(Signals::length12, payload, decoded.value.length12, decoded.status.length12);
    return decoded;
}

// Test message MotorolaPlainLong.
// From Tester to Target, every 20 ms.
struct MotorolaPlainLong {
    static constexpr const char* name{"MotorolaPlainLong"};
    static constexpr std::uint32_t identifier{0x107U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 24 bits, signed, raw * 1 + 0. -8388608 to 8388607.
    std::int32_t length24{0};
    // 27 bits, unsigned, raw * 1 + 0. 0 to 134217727.
    std::uint32_t length27{0U};
    // 28 bits, signed, raw * 1 + 0. -134217728 to 134217727.
    std::int32_t length28{0};
    // 32 bits, signed, raw * 1 + 0. -2147483648 to 2147483647.
    std::int32_t length32{0};
    // 30 bits, signed, raw * 1 + 0. -536870912 to 536870911.
    std::int32_t length30{0};
    // 25 bits, unsigned, raw * 1 + 0. 0 to 33554431.
    std::uint32_t length25{0U};
    // 26 bits, signed, raw * 1 + 0. -33554432 to 33554431.
    std::int32_t length26{0};
    // 29 bits, unsigned, raw * 1 + 0. 0 to 536870911.
    std::uint32_t length29{0U};
    // 23 bits, unsigned, raw * 1 + 0. 0 to 8388607.
    std::uint32_t length23{0U};
    // 31 bits, unsigned, raw * 1 + 0. 0 to 2147483647.
    std::uint32_t length31{0U};

    struct Status {
        SignalStatus length24{SignalStatus::not_available};
        SignalStatus length27{SignalStatus::not_available};
        SignalStatus length28{SignalStatus::not_available};
        SignalStatus length32{SignalStatus::not_available};
        SignalStatus length30{SignalStatus::not_available};
        SignalStatus length25{SignalStatus::not_available};
        SignalStatus length26{SignalStatus::not_available};
        SignalStatus length29{SignalStatus::not_available};
        SignalStatus length23{SignalStatus::not_available};
        SignalStatus length31{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return length24 == SignalStatus::valid &&
                   length27 == SignalStatus::valid &&
                   length28 == SignalStatus::valid &&
                   length32 == SignalStatus::valid &&
                   length30 == SignalStatus::valid &&
                   length25 == SignalStatus::valid &&
                   length26 == SignalStatus::valid &&
                   length29 == SignalStatus::valid &&
                   length23 == SignalStatus::valid &&
                   length31 == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr IntegerSignal length24{
            {ByteOrder::big_endian, 4U, 24U, true}, -8388608, 8388607, 0};
        static constexpr IntegerSignal length27{
            {ByteOrder::big_endian, 28U, 27U, false}, 0, 134217727, 0};
        static constexpr IntegerSignal length28{
            {ByteOrder::big_endian, 48U, 28U, true}, -134217728, 134217727, 0};
        static constexpr IntegerSignal length32{
            {ByteOrder::big_endian, 84U, 32U, true}, -2147483647 - 1, 2147483647, 0};
        static constexpr IntegerSignal length30{
            {ByteOrder::big_endian, 115U, 30U, true}, -536870912, 536870911, 0};
        static constexpr IntegerSignal length25{
            {ByteOrder::big_endian, 147U, 25U, false}, 0, 33554431, 0};
        static constexpr IntegerSignal length26{
            {ByteOrder::big_endian, 169U, 26U, true}, -33554432, 33554431, 0};
        static constexpr IntegerSignal length29{
            {ByteOrder::big_endian, 205U, 29U, false}, 0, 536870911, 0};
        static constexpr IntegerSignal length23{
            {ByteOrder::big_endian, 224U, 23U, false}, 0, 8388607, 0};
        static constexpr IntegerSignal length31{
            {ByteOrder::big_endian, 248U, 31U, false}, 0, 2147483647, 0};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::length24, length24, payload.data());
        write_signal(Signals::length27, length27, payload.data());
        write_signal(Signals::length28, length28, payload.data());
        write_signal(Signals::length32, length32, payload.data());
        write_signal(Signals::length30, length30, payload.data());
        write_signal(Signals::length25, length25, payload.data());
        write_signal(Signals::length26, length26, payload.data());
        write_signal(Signals::length29, length29, payload.data());
        write_signal(Signals::length23, length23, payload.data());
        write_signal(Signals::length31, length31, payload.data());
        return payload;
    }

    static constexpr Decoded<MotorolaPlainLong> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Length24", "-", &MotorolaPlainLong::length24, &Status::length24);
        visitor("Length27", "-", &MotorolaPlainLong::length27, &Status::length27);
        visitor("Length28", "-", &MotorolaPlainLong::length28, &Status::length28);
        visitor("Length32", "-", &MotorolaPlainLong::length32, &Status::length32);
        visitor("Length30", "-", &MotorolaPlainLong::length30, &Status::length30);
        visitor("Length25", "-", &MotorolaPlainLong::length25, &Status::length25);
        visitor("Length26", "-", &MotorolaPlainLong::length26, &Status::length26);
        visitor("Length29", "-", &MotorolaPlainLong::length29, &Status::length29);
        visitor("Length23", "-", &MotorolaPlainLong::length23, &Status::length23);
        visitor("Length31", "-", &MotorolaPlainLong::length31, &Status::length31);
    }
};

constexpr Decoded<MotorolaPlainLong> MotorolaPlainLong::decode(const std::uint8_t* payload) {
    Decoded<MotorolaPlainLong> decoded{};
    read_signal(Signals::length24, payload, decoded.value.length24, decoded.status.length24);
    read_signal(Signals::length27, payload, decoded.value.length27, decoded.status.length27);
    read_signal(Signals::length28, payload, decoded.value.length28, decoded.status.length28);
    read_signal(Signals::length32, payload, decoded.value.length32, decoded.status.length32);
    read_signal(Signals::length30, payload, decoded.value.length30, decoded.status.length30);
    read_signal(Signals::length25, payload, decoded.value.length25, decoded.status.length25);
    read_signal(Signals::length26, payload, decoded.value.length26, decoded.status.length26);
    read_signal(Signals::length29, payload, decoded.value.length29, decoded.status.length29);
    read_signal(Signals::length23, payload, decoded.value.length23, decoded.status.length23);
    read_signal(Signals::length31, payload, decoded.value.length31, decoded.status.length31);
    return decoded;
}

// Test message MixedOrders.
// From Tester to Target, every 20 ms.
struct MixedOrders {
    // A signed enumeration with gaps and a missing code.
    enum class SignedLevel : std::int8_t {
        not_available = -4,
        low = -2,
        normal = 0,
        high = 2,
    };

    static constexpr const char* name{"MixedOrders"};
    static constexpr std::uint32_t identifier{0x18FF1234U};
    static constexpr bool extended{true};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // Intel, crosses a byte. deg, -500 to 500.
    float intel_crossing_deg{not_available};
    // Motorola, starts in the lowest bit of a byte. km/h, -10 to 190.
    float motorola_crossing_kmh{not_available};
    // Motorola, touches three bytes. m/s^2, -250 to 250.
    float motorola_three_bytes_mps2{0.0F};
    // A signed enumeration with gaps and a missing code.
    SignedLevel signed_level{SignedLevel::normal};
    // A flag that starts set.
    bool flag{true};
    // An integer whose range does not begin at zero. 3 to 20.
    std::uint8_t small_integer{7U};

    struct Status {
        SignalStatus intel_crossing_deg{SignalStatus::not_available};
        SignalStatus motorola_crossing_kmh{SignalStatus::not_available};
        SignalStatus motorola_three_bytes_mps2{SignalStatus::not_available};
        SignalStatus signed_level{SignalStatus::not_available};
        SignalStatus flag{SignalStatus::not_available};
        SignalStatus small_integer{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return intel_crossing_deg == SignalStatus::valid &&
                   motorola_crossing_kmh == SignalStatus::valid &&
                   motorola_three_bytes_mps2 == SignalStatus::valid &&
                   signed_level == SignalStatus::valid &&
                   flag == SignalStatus::valid &&
                   small_integer == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> intel_crossing_deg{
            {ByteOrder::little_endian, 5U, 11U, true}, 1.0F, 2.0F, 2.0F, -500.0F, 500.0F,
            -1002, 998, -1024, true};
        static constexpr PhysicalSignal<std::int32_t> motorola_crossing_kmh{
            {ByteOrder::big_endian, 16U, 10U, false}, 1.0F, -50.0F, 5.0F, -10.0F, 190.0F,
            0, 1000, 1023, true};
        static constexpr PhysicalSignal<std::int32_t> motorola_three_bytes_mps2{
            {ByteOrder::big_endian, 36U, 19U, true}, 1.0F, 0.0F, 1000.0F, -250.0F, 250.0F,
            -250000, 250000, -262144, true};
        static constexpr EnumerationSignal signed_level{
            {ByteOrder::big_endian, 49U, 3U, true}, 0, true, -4};
        static constexpr IntegerSignal flag{
            {ByteOrder::big_endian, 57U, 1U, false}, 0, 1, 1};
        static constexpr IntegerSignal small_integer{
            {ByteOrder::little_endian, 58U, 5U, false}, 3, 20, 7};
    };

    static constexpr bool is_known(SignedLevel value) {
        switch (value) {
            case SignedLevel::not_available:
            case SignedLevel::low:
            case SignedLevel::normal:
            case SignedLevel::high:
                return true;
        }
        return false;
    }

    // The value's name in the DBC file, or "unknown".
    static constexpr const char* name_of(SignedLevel value) {
        switch (value) {
            case SignedLevel::not_available:
                return "not available";
            case SignedLevel::low:
                return "low";
            case SignedLevel::normal:
                return "normal";
            case SignedLevel::high:
                return "high";
        }
        return "unknown";
    }

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::intel_crossing_deg, intel_crossing_deg, payload.data());
        write_signal(Signals::motorola_crossing_kmh, motorola_crossing_kmh, payload.data());
        write_signal(Signals::motorola_three_bytes_mps2, motorola_three_bytes_mps2, payload.data());
        write_enumeration(Signals::signed_level, &MixedOrders::is_known, signed_level, payload.data());
        write_signal(Signals::flag, flag, payload.data());
        write_signal(Signals::small_integer, small_integer, payload.data());
        return payload;
    }

    static constexpr Decoded<MixedOrders> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("IntelCrossing", "deg", &MixedOrders::intel_crossing_deg, &Status::intel_crossing_deg);
        visitor("MotorolaCrossing", "km/h", &MixedOrders::motorola_crossing_kmh, &Status::motorola_crossing_kmh);
        visitor("MotorolaThreeBytes", "m/s^2", &MixedOrders::motorola_three_bytes_mps2, &Status::motorola_three_bytes_mps2);
        visitor("SignedLevel", "-", &MixedOrders::signed_level, &Status::signed_level);
        visitor("Flag", "-", &MixedOrders::flag, &Status::flag);
        visitor("SmallInteger", "-", &MixedOrders::small_integer, &Status::small_integer);
    }
};

constexpr Decoded<MixedOrders> MixedOrders::decode(const std::uint8_t* payload) {
    Decoded<MixedOrders> decoded{};
    read_signal(Signals::intel_crossing_deg, payload, decoded.value.intel_crossing_deg, decoded.status.intel_crossing_deg);
    read_signal(Signals::motorola_crossing_kmh, payload, decoded.value.motorola_crossing_kmh, decoded.status.motorola_crossing_kmh);
    read_signal(Signals::motorola_three_bytes_mps2, payload, decoded.value.motorola_three_bytes_mps2, decoded.status.motorola_three_bytes_mps2);
    read_enumeration(Signals::signed_level, &MixedOrders::is_known, payload, decoded.value.signed_level, decoded.status.signed_level);
    read_signal(Signals::flag, payload, decoded.value.flag, decoded.status.flag);
    read_signal(Signals::small_integer, payload, decoded.value.small_integer, decoded.status.small_integer);
    return decoded;
}

// Test message Unaligned32.
// From Tester to Target, every 20 ms.
struct Unaligned32 {
    static constexpr const char* name{"Unaligned32"};
    static constexpr std::uint32_t identifier{0x200U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{8U};
    static constexpr std::uint16_t cycle_time_ms{20U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // 32 bits over five bytes, Motorola. -2147483648 to 2147483647.
    std::int32_t motorola_word{0};
    // 24 bits, Intel, scaled. m, -1000000 to 1000000.
    float intel_scaled_m{not_available};

    struct Status {
        SignalStatus motorola_word{SignalStatus::not_available};
        SignalStatus intel_scaled_m{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return motorola_word == SignalStatus::valid &&
                   intel_scaled_m == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr IntegerSignal motorola_word{
            {ByteOrder::big_endian, 2U, 32U, true}, -2147483647 - 1, 2147483647, 0};
        static constexpr PhysicalSignal<std::int32_t> intel_scaled_m{
            {ByteOrder::little_endian, 40U, 24U, true}, 1.0F, 800.0F, 8.0F, -1000000.0F, 1000000.0F,
            -8000800, 7999200, -8388608, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::motorola_word, motorola_word, payload.data());
        write_signal(Signals::intel_scaled_m, intel_scaled_m, payload.data());
        return payload;
    }

    static constexpr Decoded<Unaligned32> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("MotorolaWord", "-", &Unaligned32::motorola_word, &Status::motorola_word);
        visitor("IntelScaled", "m", &Unaligned32::intel_scaled_m, &Status::intel_scaled_m);
    }
};

constexpr Decoded<Unaligned32> Unaligned32::decode(const std::uint8_t* payload) {
    Decoded<Unaligned32> decoded{};
    read_signal(Signals::motorola_word, payload, decoded.value.motorola_word, decoded.status.motorola_word);
    read_signal(Signals::intel_scaled_m, payload, decoded.value.intel_scaled_m, decoded.status.intel_scaled_m);
    return decoded;
}

// Calls visitor(MessageType<Message>{}) for each message of the DBC file.
template <typename Visitor>
constexpr void visit_messages(Visitor&& visitor) {
    visitor(MessageType<IntelScaledShort>{});
    visitor(MessageType<IntelScaledLong>{});
    visitor(MessageType<IntelPlainShort>{});
    visitor(MessageType<IntelPlainLong>{});
    visitor(MessageType<MotorolaScaledShort>{});
    visitor(MessageType<MotorolaScaledLong>{});
    visitor(MessageType<MotorolaPlainShort>{});
    visitor(MessageType<MotorolaPlainLong>{});
    visitor(MessageType<MixedOrders>{});
    visitor(MessageType<Unaligned32>{});
}

// Frames of Tester, in the file's order.
using MessagesFromTester = MessageList<IntelScaledShort, IntelScaledLong, IntelPlainShort, IntelPlainLong, MotorolaScaledShort, MotorolaScaledLong, MotorolaPlainShort, MotorolaPlainLong, MixedOrders, Unaligned32>;

}  // namespace byte_orders
