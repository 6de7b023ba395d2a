// Uses all of the codec and of the end-to-end protection, so that its object file shows what they need at run
// time.
#include <array>
#include <cstdint>

#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/e2e/state_machine.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"

namespace {

constexpr rsi::can_dbc::e2e::StateMachineSettings channel_settings{4U, {1U, 1U}, {1U, 2U}, {2U, 0U}, false};

}  // namespace

// Decodes and encodes a payload as every message in turn; what matters is the object file.
extern "C" void codec_footprint(std::array<std::uint8_t, 8>& payload, std::uint8_t length);

extern "C" void codec_footprint(std::array<std::uint8_t, 8>& payload, std::uint8_t length) {
    rsi::can_dbc::visit_messages([&payload, length](auto type) {
        using Message = typename decltype(type)::Type;
        rsi::can_dbc::e2e::Profile11Receiver receiver{Message::e2e_data_id, Message::length, 2U};
        rsi::can_dbc::e2e::StateMachine<channel_settings> channel;
        rsi::can_dbc::e2e::Profile11Sender sender{Message::e2e_data_id};
        channel.update(receiver.check(payload, length).status);
        if (channel.is_valid()) {
            auto encoded = rsi::can_dbc::encode(rsi::can_dbc::decode<Message>(payload).value);
            sender.protect(encoded);
            for (std::size_t index = 0U; index < encoded.size(); ++index) {
                payload[index] = encoded[index];
            }
        }
    });
}
