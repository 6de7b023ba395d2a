// The generated codec against a reader of the DBC file that shares nothing with it: every message decoded
// from any bytes, encoded from any values, and there and back again.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/dbc_file.hpp"
#include "tests/quality/fuzz/support/require.hpp"

namespace {

using fuzz::ByteReader;
using fuzz::DbcMessage;
using fuzz::DbcSignal;
using fuzz::require;
using rsi::can_dbc::SignalStatus;

const std::map<std::string, DbcMessage>& database() {
    static const std::map<std::string, DbcMessage> read = fuzz::read_dbc(RSI_DBC_FILE);
    return read;
}

// The signals of a message in the order in which it visits them.
template <typename Message>
const std::vector<DbcSignal>& signals_of() {
    static const std::vector<DbcSignal> found = [] {
        const DbcMessage& message = database().at(Message::name);
        require(message.length == Message::length, "the message has the length of the DBC file");
        std::vector<DbcSignal> all;
        Message::visit_signals(
            [&](const char* name, const char*, auto, auto) { all.push_back(message.signals.at(name)); });
        return all;
    }();
    return found;
}

template <typename Value>
SignalStatus status_in_dbc(const DbcSignal& signal, std::int64_t raw) {
    if (signal.not_available == raw) {
        return SignalStatus::not_available;
    }
    const bool known =
        std::is_enum_v<Value> ? signal.named.count(raw) == 1U : signal.admits(signal.physical(raw));
    return known ? SignalStatus::valid : SignalStatus::out_of_range;
}

void check_decoded(float value, const DbcSignal& signal, std::int64_t raw, SignalStatus status) {
    if (status != SignalStatus::valid) {
        require(std::isnan(value), "a physical value that is not valid is NaN");
        return;
    }
    const double expected = signal.physical(raw);
    require(std::fabs(static_cast<double>(value) - expected) <= 1.0e-6 * std::fabs(expected),
            "a physical value is that of the DBC file");
}

template <typename Value>
void check_decoded(Value value, const DbcSignal& signal, std::int64_t raw, SignalStatus status) {
    const std::int64_t expected = status == SignalStatus::out_of_range ? signal.start_value : raw;
    require(static_cast<std::int64_t>(value) == expected,
            "an integer is what the bits say, or the start value");
}

template <typename Message>
void check_decoding(const std::array<std::uint8_t, 8>& payload) {
    const rsi::can_dbc::Decoded<Message> decoded = rsi::can_dbc::decode<Message>(payload);
    auto signal = signals_of<Message>().begin();
    bool all_valid = true;
    Message::visit_signals([&](const char*, const char*, auto member, auto status_member) {
        using Value = std::decay_t<decltype(decoded.value.*member)>;
        const std::int64_t raw = signal->raw(payload.data());
        const SignalStatus status = decoded.status.*status_member;
        require(status == status_in_dbc<Value>(*signal, raw), "the status is that of the DBC file");
        check_decoded(decoded.value.*member, *signal, raw, status);
        all_valid = all_valid && status == SignalStatus::valid;
        ++signal;
    });
    require(decoded.status.all_valid() == all_valid, "all_valid() says whether every status is valid");
}

std::int64_t nearest_code(const DbcSignal& signal, double value) {
    return std::llround((value - signal.offset) / signal.factor);
}

void check_encoded(float value, const DbcSignal& signal, std::int64_t raw) {
    if (std::isnan(value)) {
        require(raw == signal.not_available.value_or(signal.start_value), "NaN is sent as not available");
        return;
    }
    const double wanted = std::clamp(static_cast<double>(value), signal.minimum, signal.maximum);
    require(signal.not_available != raw, "a number is not sent as not available");
    require(signal.admits(signal.physical(raw)), "a number is sent within the range");
    // In float a value halfway between two codes may fall to either side.
    require(std::fabs(signal.physical(raw) - wanted) <= 0.5001 * signal.factor + 1.0e-6 * std::fabs(wanted) ||
                raw == nearest_code(signal, wanted),
            "a number is sent as the nearest code");
}

template <typename Value>
void check_encoded(Value value, const DbcSignal& signal, std::int64_t raw) {
    const auto wide = static_cast<std::int64_t>(value);
    if constexpr (std::is_enum_v<Value>) {
        const bool known = signal.named.count(wide) == 1U || signal.not_available == wide;
        require(raw == (known ? wide : signal.start_value),
                "an enumerator is sent as it is, or the start value");
    } else {
        require(raw == std::clamp(wide, static_cast<std::int64_t>(signal.minimum),
                                  static_cast<std::int64_t>(signal.maximum)),
                "an integer is sent as it is, or as the nearest limit");
    }
}

// A message is sent as the DBC file says, all bits but the signals' are zero, and a receiver that decodes
// it and sends it on sends the same.
template <typename Message>
void check_encoding(const Message& message) {
    const auto payload = rsi::can_dbc::encode(message);
    auto signal = signals_of<Message>().begin();
    std::uint64_t mask = 0U;
    Message::visit_signals([&](const char*, const char*, auto member, auto) {
        check_encoded(message.*member, *signal, signal->raw(payload.data()));
        mask |= signal->mask();
        ++signal;
    });
    std::uint64_t bits = 0U;
    for (std::size_t index = 0U; index < payload.size(); ++index) {
        bits |= std::uint64_t{payload[index]} << (8U * index);
    }
    require((bits & ~mask) == 0U, "every bit that belongs to no signal is zero");

    const rsi::can_dbc::Decoded<Message> decoded = rsi::can_dbc::decode<Message>(payload);
    Message::visit_signals([&](const char*, const char*, auto, auto status_member) {
        require(decoded.status.*status_member != SignalStatus::out_of_range,
                "nothing undefined is ever sent");
    });
    require(rsi::can_dbc::encode(decoded.value) == payload,
            "what was sent and received is sent again as the same");
}

// Any bits, but now and then a number near the signal's range, where the interesting ones lie.
void fill(float& value, const DbcSignal& signal, ByteReader& bytes) {
    if (bytes.one_in(2U)) {
        const double share = static_cast<double>(bytes.take<std::int16_t>()) / 30000.0;
        const double half_range = 0.5 * (signal.maximum - signal.minimum);
        value = static_cast<float>(0.5 * (signal.maximum + signal.minimum) + share * half_range);
    } else {
        value = bytes.take<float>();
    }
}

template <typename Value>
void fill(Value& value, const DbcSignal&, ByteReader& bytes) {
    if constexpr (std::is_same_v<Value, bool>) {
        value = bytes.one_in(2U);
    } else if constexpr (std::is_enum_v<Value>) {
        value = static_cast<Value>(bytes.take<std::underlying_type_t<Value>>());
    } else {
        value = bytes.take<Value>();
    }
}

template <typename Message>
void check(ByteReader& bytes) {
    std::array<std::uint8_t, 8> payload{};
    bytes.take_into(payload.data(), Message::length);
    check_decoding<Message>(payload);
    check_encoding(rsi::can_dbc::decode<Message>(payload).value);

    Message message{};
    auto signal = signals_of<Message>().begin();
    Message::visit_signals([&](const char*, const char*, auto member, auto) {
        fill(message.*member, *signal, bytes);
        ++signal;
    });
    check_encoding(message);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ByteReader bytes{data, size};
    const unsigned chosen = bytes.below(16U);
    unsigned index = 0U;
    rsi::can_dbc::visit_messages([&](auto type) {
        // The numbers left over mean "all of them".
        if (index++ == chosen || chosen >= 10U) {
            check<typename decltype(type)::Type>(bytes);
        }
    });
    return 0;
}
