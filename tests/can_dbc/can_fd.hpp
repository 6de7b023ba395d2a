// Codec of can_fd.dbc, written by can_dbc/generator/generate.py: change the DBC file, not this one.
// clang-format off
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/can_dbc/codec/integer_signal.hpp"
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/codec/physical_signal.hpp"

namespace can_fd {

using namespace rsi::can_dbc;

// Test message CornerForces.
// From Tester to Target, every 10 ms.
struct CornerForces {
    static constexpr const char* name{"CornerForces"};
    static constexpr std::uint32_t identifier{0x300U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{64U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // Test signal of 16 bits. N, 0 to 131000.
    float front_left_n{not_available};
    // Test signal of 16 bits. N, -16000 to 16000.
    float front_right_n{0.0F};
    // Test signal of 3 bits. 0 to 7.
    std::uint8_t mode{0U};
    // Test signal of 24 bits. N, 0 to 160000.
    float rear_left_n{0.0F};
    // Test signal of 32 bits. N, -20000000 to 20000000.
    float rear_right_n{0.0F};

    struct Status {
        SignalStatus front_left_n{SignalStatus::not_available};
        SignalStatus front_right_n{SignalStatus::not_available};
        SignalStatus mode{SignalStatus::not_available};
        SignalStatus rear_left_n{SignalStatus::not_available};
        SignalStatus rear_right_n{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return front_left_n == SignalStatus::valid &&
                   front_right_n == SignalStatus::valid &&
                   mode == SignalStatus::valid &&
                   rear_left_n == SignalStatus::valid &&
                   rear_right_n == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> front_left_n{
            {ByteOrder::little_endian, 24U, 16U, false}, 2.0F, 0.0F, 1.0F, 0.0F, 131000.0F,
            0, 65500, 65535, true};
        static constexpr PhysicalSignal<std::int32_t> front_right_n{
            {ByteOrder::big_endian, 55U, 16U, true}, 1.0F, 0.0F, 2.0F, -16000.0F, 16000.0F,
            -32000, 32000, 0, false};
        static constexpr IntegerSignal mode{
            {ByteOrder::little_endian, 64U, 3U, false}, 0, 7, 0};
        static constexpr PhysicalSignal<std::int32_t> rear_left_n{
            {ByteOrder::big_endian, 311U, 24U, false}, 1.0F, 0.0F, 100.0F, 0.0F, 160000.0F,
            0, 16000000, 0, false};
        static constexpr PhysicalSignal<std::int64_t> rear_right_n{
            {ByteOrder::little_endian, 480U, 32U, true}, 1.0F, 0.0F, 100.0F, -20000000.0F, 20000000.0F,
            -2000000000, 2000000000, 0, false};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::front_left_n, front_left_n, payload.data());
        write_signal(Signals::front_right_n, front_right_n, payload.data());
        write_signal(Signals::mode, mode, payload.data());
        write_signal(Signals::rear_left_n, rear_left_n, payload.data());
        write_signal(Signals::rear_right_n, rear_right_n, payload.data());
        return payload;
    }

    static constexpr Decoded<CornerForces> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("FrontLeft", "N", &CornerForces::front_left_n, &Status::front_left_n);
        visitor("FrontRight", "N", &CornerForces::front_right_n, &Status::front_right_n);
        visitor("Mode", "-", &CornerForces::mode, &Status::mode);
        visitor("RearLeft", "N", &CornerForces::rear_left_n, &Status::rear_left_n);
        visitor("RearRight", "N", &CornerForces::rear_right_n, &Status::rear_right_n);
    }
};

constexpr Decoded<CornerForces> CornerForces::decode(const std::uint8_t* payload) {
    Decoded<CornerForces> decoded{};
    read_signal(Signals::front_left_n, payload, decoded.value.front_left_n, decoded.status.front_left_n);
    read_signal(Signals::front_right_n, payload, decoded.value.front_right_n, decoded.status.front_right_n);
    read_signal(Signals::mode, payload, decoded.value.mode, decoded.status.mode);
    read_signal(Signals::rear_left_n, payload, decoded.value.rear_left_n, decoded.status.rear_left_n);
    read_signal(Signals::rear_right_n, payload, decoded.value.rear_right_n, decoded.status.rear_right_n);
    return decoded;
}

// Test message BodyMotion.
// From Tester to Target, every 10 ms.
struct BodyMotion {
    static constexpr const char* name{"BodyMotion"};
    static constexpr std::uint32_t identifier{0x301U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{24U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // Test signal of 16 bits. deg/s, -300 to 300.
    float yaw_rate_deg_per_s{not_available};
    // Test signal of 16 bits. deg/s, -300 to 300.
    float roll_rate_deg_per_s{not_available};
    // Test signal of 1 bit.
    bool ready{false};
    // Test signal of 16 bits. deg, -120 to 120.
    float roll_angle_deg{not_available};

    struct Status {
        SignalStatus yaw_rate_deg_per_s{SignalStatus::not_available};
        SignalStatus roll_rate_deg_per_s{SignalStatus::not_available};
        SignalStatus ready{SignalStatus::not_available};
        SignalStatus roll_angle_deg{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return yaw_rate_deg_per_s == SignalStatus::valid &&
                   roll_rate_deg_per_s == SignalStatus::valid &&
                   ready == SignalStatus::valid &&
                   roll_angle_deg == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> yaw_rate_deg_per_s{
            {ByteOrder::little_endian, 0U, 16U, true}, 1.0F, 0.0F, 100.0F, -300.0F, 300.0F,
            -30000, 30000, -32768, true};
        static constexpr PhysicalSignal<std::int32_t> roll_rate_deg_per_s{
            {ByteOrder::big_endian, 23U, 16U, true}, 1.0F, 0.0F, 100.0F, -300.0F, 300.0F,
            -30000, 30000, -32768, true};
        static constexpr IntegerSignal ready{
            {ByteOrder::little_endian, 32U, 1U, false}, 0, 1, 0};
        static constexpr PhysicalSignal<std::int32_t> roll_angle_deg{
            {ByteOrder::little_endian, 176U, 16U, true}, 1.0F, 0.0F, 200.0F, -120.0F, 120.0F,
            -24000, 24000, -32768, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::yaw_rate_deg_per_s, yaw_rate_deg_per_s, payload.data());
        write_signal(Signals::roll_rate_deg_per_s, roll_rate_deg_per_s, payload.data());
        write_signal(Signals::ready, ready, payload.data());
        write_signal(Signals::roll_angle_deg, roll_angle_deg, payload.data());
        return payload;
    }

    static constexpr Decoded<BodyMotion> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("YawRate", "deg/s", &BodyMotion::yaw_rate_deg_per_s, &Status::yaw_rate_deg_per_s);
        visitor("RollRate", "deg/s", &BodyMotion::roll_rate_deg_per_s, &Status::roll_rate_deg_per_s);
        visitor("Ready", "-", &BodyMotion::ready, &Status::ready);
        visitor("RollAngle", "deg", &BodyMotion::roll_angle_deg, &Status::roll_angle_deg);
    }
};

constexpr Decoded<BodyMotion> BodyMotion::decode(const std::uint8_t* payload) {
    Decoded<BodyMotion> decoded{};
    read_signal(Signals::yaw_rate_deg_per_s, payload, decoded.value.yaw_rate_deg_per_s, decoded.status.yaw_rate_deg_per_s);
    read_signal(Signals::roll_rate_deg_per_s, payload, decoded.value.roll_rate_deg_per_s, decoded.status.roll_rate_deg_per_s);
    read_signal(Signals::ready, payload, decoded.value.ready, decoded.status.ready);
    read_signal(Signals::roll_angle_deg, payload, decoded.value.roll_angle_deg, decoded.status.roll_angle_deg);
    return decoded;
}

// Test message PlainFd.
// From Tester to Target, every 10 ms.
struct PlainFd {
    static constexpr const char* name{"PlainFd"};
    static constexpr std::uint32_t identifier{0x18FF0302U};
    static constexpr bool extended{true};
    static constexpr bool flexible_data_rate{true};
    static constexpr std::uint8_t length{12U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // Test signal of 8 bits. degC, -40 to 120.
    float temperature_deg_c{not_available};

    struct Status {
        SignalStatus temperature_deg_c{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return temperature_deg_c == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr PhysicalSignal<std::int32_t> temperature_deg_c{
            {ByteOrder::little_endian, 88U, 8U, true}, 1.0F, 0.0F, 1.0F, -40.0F, 120.0F,
            -40, 120, -128, true};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::temperature_deg_c, temperature_deg_c, payload.data());
        return payload;
    }

    static constexpr Decoded<PlainFd> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("Temperature", "degC", &PlainFd::temperature_deg_c, &Status::temperature_deg_c);
    }
};

constexpr Decoded<PlainFd> PlainFd::decode(const std::uint8_t* payload) {
    Decoded<PlainFd> decoded{};
    read_signal(Signals::temperature_deg_c, payload, decoded.value.temperature_deg_c, decoded.status.temperature_deg_c);
    return decoded;
}

// Calls visitor(MessageType<Message>{}) for each message of the DBC file.
template <typename Visitor>
constexpr void visit_messages(Visitor&& visitor) {
    visitor(MessageType<CornerForces>{});
    visitor(MessageType<BodyMotion>{});
    visitor(MessageType<PlainFd>{});
}

// Frames of Tester, in the file's order.
using MessagesFromTester = MessageList<CornerForces, BodyMotion, PlainFd>;

}  // namespace can_fd
