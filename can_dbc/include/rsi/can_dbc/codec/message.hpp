// Encoding and decoding of whole messages, for every message struct that the generator writes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/can_dbc/codec/signal_status.hpp"

namespace rsi::can_dbc {

// A decoded message: the values, and for each of them whether it may be used.
// A value whose status is not valid is NaN (physical signals) or the signal's start value (all others).
template <typename Message>
struct Decoded {
    Message value{};
    typename Message::Status status{};
};

// The payload of a message. Unused bits and the bits of the end-to-end protection are zero; see
// can_dbc/include/rsi/can_dbc/e2e for the latter.
template <typename Message>
constexpr std::array<std::uint8_t, Message::length> encode(const Message& message) {
    return message.encode();
}

// Decodes a payload whose first Message::length bytes were received; the caller has compared the frame's
// length and checked its end-to-end protection.
template <typename Message, std::size_t size>
constexpr Decoded<Message> decode(const std::array<std::uint8_t, size>& payload) {
    static_assert(size >= Message::length, "the payload is shorter than the message");
    return Message::decode(payload.data());
}

// Stands for a message type in generic code: visit_messages calls its visitor with one for each message.
template <typename Message>
struct MessageType {
    using Type = Message;
};

// Stands for several message types, as in the generated MessagesFromNODE.
template <typename... Messages>
struct MessageList {
    static constexpr std::size_t size{sizeof...(Messages)};
    static constexpr std::array<std::uint32_t, size> identifiers{Messages::identifier...};

    // Calls visitor(MessageType<Message>{}) for each, in their order.
    template <typename Visitor>
    static constexpr void visit(Visitor&& visitor) {
        (visitor(MessageType<Messages>{}), ...);
    }
};

}  // namespace rsi::can_dbc
