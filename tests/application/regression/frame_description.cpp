#include "tests/application/regression/frame_description.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "sil/simulation/simulation.hpp"

namespace sil {
namespace {

template <typename Message, typename Value>
std::string value_text(Value value) {
    if constexpr (std::is_enum_v<Value>) {
        return Message::name_of(value);
    } else {
        return fmt::format("{}", value);
    }
}

template <typename Message>
std::string describe_message(const rsi::hal::CanFrame& frame) {
    const auto decoded = rsi::can_dbc::decode<Message>(frame.data);
    std::string text = Message::name;
    Message::visit_signals([&](const char* name, const char* unit, auto member, auto status) {
        text += fmt::format(" {}=", name);
        switch (decoded.status.*status) {
            case rsi::can_dbc::SignalStatus::valid:
                text += value_text<Message>(decoded.value.*member);
                text += (unit[0] != '\0' && unit[0] != '-') ? fmt::format(" {}", unit) : "";
                break;
            case rsi::can_dbc::SignalStatus::not_available:
                text += "(not available)";
                break;
            case rsi::can_dbc::SignalStatus::out_of_range:
                text += "(out of range)";
                break;
        }
    });
    return text;
}

}  // namespace

std::string describe_frame(const rsi::hal::CanFrame& frame) {
    std::string text;
    const auto describe_if_it_is = [&](auto type) {
        using Message = typename decltype(type)::Type;
        if (frame.identifier == Message::identifier && frame.extended == Message::extended &&
            frame.length == Message::length) {
            text = describe_message<Message>(frame);
        }
    };
    rsi::can_dbc::visit_messages(describe_if_it_is);
    simulation_dbc::visit_messages(describe_if_it_is);
    return text;
}

}  // namespace sil
