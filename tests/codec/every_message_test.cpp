// What holds for every message and every signal of both CAN databases, whatever the generator writes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "can_dbc/generated/rollover_warning.hpp"
#include "tests/codec/byte_orders.hpp"

namespace {

using can_dbc::Decoded;
using can_dbc::SignalStatus;

// Calls `check` with an instance of each message of both databases.
template <typename Check>
void for_every_message(Check check) {
    const auto of_type = [&check](auto type) { check(typename decltype(type)::Type{}); };
    can_dbc::visit_messages(of_type);
    byte_orders::visit_messages(of_type);
}

template <typename Message>
Decoded<Message> decoded_from(const std::array<std::uint8_t, Message::length>& payload) {
    return can_dbc::decode<Message>(payload);
}

template <typename Message>
std::array<std::uint8_t, Message::length> random_payload(std::mt19937& random) {
    std::array<std::uint8_t, Message::length> payload{};
    for (std::uint8_t& byte : payload) {
        byte = static_cast<std::uint8_t>(random() & 0xFFU);
    }
    return payload;
}

// A wide signal with a factor is only as exact as a float.
template <typename Value>
bool same(Value left, Value right) {
    if constexpr (std::is_floating_point_v<Value>) {
        return std::fabs(left - right) <= 4.0F * std::numeric_limits<Value>::epsilon() * std::fabs(left);
    } else {
        return left == right;
    }
}

TEST(EveryMessage, IsValidAsAWholeOnlyWhenEachOfItsSignalsIs) {
    for_every_message([](auto message) {
        using Message = decltype(message);
        typename Message::Status status{};
        Message::visit_signals(
            [&](const char*, const char*, auto, auto member) { status.*member = SignalStatus::valid; });
        EXPECT_TRUE(status.all_valid()) << Message::name;
        Message::visit_signals([&](const char* signal, const char*, auto, auto member) {
            for (const SignalStatus bad : {SignalStatus::not_available, SignalStatus::out_of_range}) {
                typename Message::Status one_bad = status;
                one_bad.*member = bad;
                EXPECT_FALSE(one_bad.all_valid()) << Message::name << "." << signal;
            }
        });
    });
}

TEST(EveryMessage, DecodedAndEncodedAgainSaysTheSame) {
    std::mt19937 random{1U};
    for_every_message([&random](auto message) {
        using Message = decltype(message);
        for (int draw = 0; draw < 2000; ++draw) {
            const auto received = decoded_from<Message>(random_payload<Message>(random));
            const auto again = decoded_from<Message>(can_dbc::encode(received.value));
            Message::visit_signals([&](const char* signal, const char*, auto value, auto status) {
                if (received.status.*status == SignalStatus::valid) {
                    EXPECT_EQ(again.status.*status, SignalStatus::valid) << Message::name << "." << signal;
                    EXPECT_TRUE(same(again.value.*value, received.value.*value))
                        << Message::name << "." << signal;
                }
            });
        }
    });
}

// What a receiver cannot use gives it no number: NaN, or what the signal starts with. (An enumeration may
// have an enumerator for "not available".)
TEST(EveryMessage, GivesNoNumberForASignalThatIsNotValid) {
    std::mt19937 random{2U};
    for_every_message([&random](auto message) {
        using Message = decltype(message);
        for (int draw = 0; draw < 2000; ++draw) {
            const auto received = decoded_from<Message>(random_payload<Message>(random));
            Message::visit_signals([&](const char* signal, const char*, auto value, auto status) {
                using Value = std::decay_t<decltype(message.*value)>;
                if (received.status.*status == SignalStatus::valid) {
                    return;
                }
                if constexpr (std::is_floating_point_v<Value>) {
                    EXPECT_TRUE(std::isnan(received.value.*value)) << Message::name << "." << signal;
                } else if (received.status.*status == SignalStatus::out_of_range) {
                    EXPECT_EQ(received.value.*value, Message{}.*value) << Message::name << "." << signal;
                }
            });
        }
    });
}

// The extremes of each type: sent saturated or as "not available", never as a code that nobody may use.
TEST(EveryMessage, NeverSendsACodeOutOfRange) {
    const auto expect_in_range = [](const auto& message) {
        using Message = std::decay_t<decltype(message)>;
        const auto received = decoded_from<Message>(can_dbc::encode(message));
        Message::visit_signals([&](const char* signal, const char*, auto, auto status) {
            EXPECT_NE(received.status.*status, SignalStatus::out_of_range) << Message::name << "." << signal;
        });
    };
    for_every_message([&expect_in_range](auto message) {
        using Message = decltype(message);
        for (const bool largest : {false, true}) {
            Message extreme{};
            Message::visit_signals([&](const char*, const char*, auto value, auto) {
                using Value = std::decay_t<decltype(message.*value)>;
                if constexpr (std::is_enum_v<Value>) {
                    using Number = std::underlying_type_t<Value>;
                    extreme.*value = static_cast<Value>(largest ? std::numeric_limits<Number>::max()
                                                                : std::numeric_limits<Number>::min());
                } else {
                    extreme.*value =
                        largest ? std::numeric_limits<Value>::max() : std::numeric_limits<Value>::lowest();
                }
            });
            expect_in_range(extreme);
        }
    });
}

// Every name of an enumeration in the order of its numbers; "unknown" belongs to all others alone.
template <typename Message, typename Enumeration>
std::vector<std::string> names_of() {
    using Number = std::underlying_type_t<Enumeration>;
    std::vector<std::string> names;
    for (int number = std::numeric_limits<Number>::min(); number <= std::numeric_limits<Number>::max();
         ++number) {
        const auto value = static_cast<Enumeration>(number);
        const std::string name = Message::name_of(value);
        EXPECT_EQ(Message::is_known(value), name != "unknown") << number;
        if (Message::is_known(value)) {
            names.push_back(name);
        }
    }
    return names;
}

TEST(EveryEnumeration, HasTheNamesOfTheDbcFile) {
    using Names = std::vector<std::string>;
    using can_dbc::RollObserver;
    using can_dbc::RolloverWarning;
    EXPECT_EQ((names_of<RolloverWarning, RolloverWarning::State>()),
              (Names{"unavailable", "ready", "advisory", "warning"}));
    EXPECT_EQ((names_of<RolloverWarning, RolloverWarning::Side>()), (Names{"none", "left", "right"}));
    EXPECT_EQ((names_of<RolloverWarning, RolloverWarning::ParametersRefusal>()),
              (Names{"none", "missing", "version", "layout", "length", "checksum", "value"}));
    EXPECT_EQ((names_of<RollObserver, RollObserver::RollSource>()), (Names{"none", "sensor", "observer"}));
    EXPECT_EQ((names_of<RollObserver, RollObserver::ResetReason>()),
              (Names{"power on", "outside", "undefined instruction", "supervisor call", "prefetch abort",
                     "data abort", "stack overflow", "interrupt", "start without reset"}));
}

}  // namespace
