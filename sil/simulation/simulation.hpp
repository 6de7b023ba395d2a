// Codec of simulation.dbc, written by can_dbc/generator/generate.py: change the DBC file, not this one.
// clang-format off
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/can_dbc/codec/integer_signal.hpp"
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/codec/physical_signal.hpp"

namespace simulation_dbc {

using namespace rsi::can_dbc;

// Lock-step simulation only: tells the control unit to step at simulated time CycleNumber * 10 ms.
// From Simulator to RolloverEcu, every 10 ms.
struct SimulationSync {
    static constexpr const char* name{"SimulationSync"};
    static constexpr std::uint32_t identifier{0x7F0U};
    static constexpr bool extended{false};
    static constexpr bool flexible_data_rate{false};
    static constexpr std::uint8_t length{4U};
    static constexpr std::uint16_t cycle_time_ms{10U};
    static constexpr bool e2e_protected{false};
    static constexpr std::uint8_t e2e_profile{0U};  // none
    static constexpr bool has_sources{false};
    static constexpr std::uint16_t e2e_data_id{0x000U};

    // Number of the cycle to compute. 0 to 4294967295.
    std::uint32_t cycle_number{0U};

    struct Status {
        SignalStatus cycle_number{SignalStatus::not_available};

        constexpr bool all_valid() const {
            return cycle_number == SignalStatus::valid;
        }
    };

    struct Signals {
        static constexpr IntegerSignal cycle_number{
            {ByteOrder::little_endian, 0U, 32U, false}, 0, 4294967295LL, 0};
    };

    // See rsi::can_dbc::encode and decode.
    constexpr std::array<std::uint8_t, length> encode() const {
        std::array<std::uint8_t, length> payload{};
        write_signal(Signals::cycle_number, cycle_number, payload.data());
        return payload;
    }

    static constexpr Decoded<SimulationSync> decode(const std::uint8_t* payload);

    // Calls visitor(name, unit, member, status member) for each signal.
    template <typename Visitor>
    static constexpr void visit_signals(Visitor&& visitor) {
        visitor("CycleNumber", "-", &SimulationSync::cycle_number, &Status::cycle_number);
    }
};

constexpr Decoded<SimulationSync> SimulationSync::decode(const std::uint8_t* payload) {
    Decoded<SimulationSync> decoded{};
    read_signal(Signals::cycle_number, payload, decoded.value.cycle_number, decoded.status.cycle_number);
    return decoded;
}

// Calls visitor(MessageType<Message>{}) for each message of the DBC file.
template <typename Visitor>
constexpr void visit_messages(Visitor&& visitor) {
    visitor(MessageType<SimulationSync>{});
}

// Frames of Simulator, in the file's order.
using MessagesFromSimulator = MessageList<SimulationSync>;

}  // namespace simulation_dbc
