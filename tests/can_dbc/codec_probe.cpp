// Lets a script use the codec: reads one request a line and answers each with one line.
//
// - `encode FRAME SIGNAL=VALUE ...`: the payload in hexadecimal; signals not named keep their start values
// - `decode FRAME HEX`: SIGNAL=VALUE:STATUS ..., status 0 valid, 1 not available, 2 out of range
// - `protect11 DATA_ID COUNTER HEX`: eight bytes with end-to-end protection, profile 11
// - `crc8 HEX`: plain CRC-8 SAE J1850 as a decimal number
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "sil/simulation/simulation.hpp"
#include "tests/can_dbc/byte_orders.hpp"
#include "tests/can_dbc/can_fd.hpp"

namespace {

[[noreturn]] void fail(const std::string& message) {
    std::cerr << "codec_probe: " << message << '\n';
    std::exit(1);
}

std::vector<std::uint8_t> bytes_of(const std::string& hexadecimal) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t index = 0U; index + 1U < hexadecimal.size(); index += 2U) {
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(hexadecimal.substr(index, 2U), nullptr, 16)));
    }
    return bytes;
}

template <std::size_t size>
std::array<std::uint8_t, size> array_of(const std::string& hexadecimal) {
    const std::vector<std::uint8_t> bytes = bytes_of(hexadecimal);
    if (bytes.size() != size) {
        fail(std::to_string(bytes.size()) + " bytes where " + std::to_string(size) + " are expected");
    }
    std::array<std::uint8_t, size> result{};
    std::copy(bytes.begin(), bytes.end(), result.begin());
    return result;
}

template <std::size_t size>
std::string hexadecimal_of(const std::array<std::uint8_t, size>& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        std::array<char, 3> digits{};
        std::snprintf(digits.data(), digits.size(), "%02X", static_cast<unsigned>(byte));
        text += digits.data();
    }
    return text;
}

template <typename Value>
Value parsed(const std::string& text) {
    if constexpr (std::is_floating_point_v<Value>) {
        return std::strtof(text.c_str(), nullptr);
    } else {
        return static_cast<Value>(std::strtoll(text.c_str(), nullptr, 10));
    }
}

template <typename Value>
std::string printed(Value value) {
    if constexpr (std::is_floating_point_v<Value>) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.9g", static_cast<double>(value));
        return text.data();
    } else {
        return std::to_string(static_cast<long long>(value));
    }
}

template <typename Message>
std::string encoded(std::istream& arguments) {
    std::map<std::string, std::string> values;
    for (std::string argument; arguments >> argument;) {
        const std::size_t equals = argument.find('=');
        values[argument.substr(0U, equals)] = argument.substr(equals + 1U);
    }
    Message message;
    Message::visit_signals([&](const char* name, const char*, auto member, auto) {
        const auto found = values.find(name);
        if (found != values.end()) {
            using Value = std::remove_reference_t<decltype(message.*member)>;
            message.*member = parsed<Value>(found->second);
            values.erase(found);
        }
    });
    if (!values.empty()) {
        fail(std::string{Message::name} + " has no signal " + values.begin()->first);
    }
    return hexadecimal_of(rsi::can_dbc::encode(message));
}

template <typename Message>
std::string decoded(std::istream& arguments) {
    std::string hexadecimal;
    arguments >> hexadecimal;
    const auto result = rsi::can_dbc::decode<Message>(array_of<Message::length>(hexadecimal));
    std::string text;
    Message::visit_signals([&](const char* name, const char*, auto member, auto status) {
        text += std::string{text.empty() ? "" : " "} + name + '=' + printed(result.value.*member) + ':' +
                std::to_string(static_cast<int>(result.status.*status));
    });
    return text;
}

std::string answer_for_frame(const std::string& request, std::istream& arguments) {
    std::string frame;
    arguments >> frame;
    std::string answer;
    const auto try_message = [&](auto type) {
        using Message = typename decltype(type)::Type;
        if (frame == Message::name) {
            answer = request == "encode" ? encoded<Message>(arguments) : decoded<Message>(arguments);
        }
    };
    rsi::can_dbc::visit_messages(try_message);
    simulation_dbc::visit_messages(try_message);
    byte_orders::visit_messages(try_message);
    can_fd::visit_messages(try_message);
    return answer.empty() ? (fail("unknown frame " + frame), answer) : answer;
}

std::string answer_to(const std::string& line) {
    std::istringstream arguments{line};
    std::string request;
    std::string hexadecimal;
    arguments >> request;
    if (request == "encode" || request == "decode") {
        return answer_for_frame(request, arguments);
    }
    if (request == "protect11") {
        unsigned data_id = 0U;
        unsigned counter = 0U;
        arguments >> data_id >> counter >> hexadecimal;
        auto payload = array_of<8>(hexadecimal);
        rsi::can_dbc::e2e::protect_profile_11(payload, static_cast<std::uint16_t>(data_id),
                                              static_cast<std::uint8_t>(counter));
        return hexadecimal_of(payload);
    }
    if (request == "crc8") {
        arguments >> hexadecimal;
        const auto bytes = bytes_of(hexadecimal);
        return std::to_string(rsi::can_dbc::e2e::Crc8SaeJ1850::checksum(bytes.data(), bytes.size()));
    }
    fail("unknown request: " + line);
}

}  // namespace

int main() {
    for (std::string line; std::getline(std::cin, line);) {
        std::cout << answer_to(line) << '\n';
    }
    return 0;
}
