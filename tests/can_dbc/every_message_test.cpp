// Properties of every message and signal of both CAN databases, for anything that the generator writes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "sil/simulation/simulation.hpp"
#include "tests/can_dbc/byte_orders.hpp"

namespace every_message_test {
namespace {

using rsi::can_dbc::Decoded;
using rsi::can_dbc::SignalStatus;

// Calls `check` with an instance of each message of these databases.
template <typename Check>
void for_every_message(Check check) {
    const auto of_type = [&check](auto type) { check(typename decltype(type)::Type{}); };
    rsi::can_dbc::visit_messages(of_type);
    simulation_dbc::visit_messages(of_type);
    byte_orders::visit_messages(of_type);
}

template <typename Message>
Decoded<Message> decoded_from(const std::array<std::uint8_t, Message::length>& payload) {
    return rsi::can_dbc::decode<Message>(payload);
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
            const auto again = decoded_from<Message>(rsi::can_dbc::encode(received.value));
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

// An unusable value gives no number: NaN, or the start value. (An enumeration may
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

// The extremes of each type: sent saturated or as "not available", never as a reserved code.
TEST(EveryMessage, NeverSendsACodeOutOfRange) {
    const auto expect_in_range = [](const auto& message) {
        using Message = std::decay_t<decltype(message)>;
        const auto received = decoded_from<Message>(rsi::can_dbc::encode(message));
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

using Names = std::map<int, std::string>;

// The names that the line "VAL_ identifier signal ..." of a DBC file gives to numbers; no line, no names.
Names names_in(const std::string& dbc, std::uint32_t identifier, const std::string& signal) {
    std::ifstream file{RSI_PROJECT_ROOT "/" + dbc};
    EXPECT_TRUE(file.is_open()) << dbc;
    Names names;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words{line};
        std::string keyword;
        std::string frame;
        std::string of_signal;
        words >> keyword >> frame >> of_signal;
        if (keyword != "VAL_" || frame != std::to_string(identifier) || of_signal != signal) {
            continue;
        }
        int number = 0;
        for (std::string name; words >> number >> std::quoted(name);) {
            names[number] = name;
        }
    }
    return names;
}

// Those that the generated code gives; "unknown" belongs to all other numbers alone.
template <typename Message, typename Enumeration>
Names names_of() {
    using Number = std::underlying_type_t<Enumeration>;
    Names names;
    for (int number = std::numeric_limits<Number>::min(); number <= std::numeric_limits<Number>::max();
         ++number) {
        const auto value = static_cast<Enumeration>(number);
        const std::string name = Message::name_of(value);
        EXPECT_EQ(Message::is_known(value), name != "unknown") << number;
        if (Message::is_known(value)) {
            names[number] = name;
        }
    }
    return names;
}

// How many enumerations the message has.
template <typename Message>
int expect_names_of_dbc(const std::string& dbc) {
    constexpr std::uint32_t extended_bit = 0x80000000U;  // as a DBC file marks 29-bit identifiers
    int enumerations = 0;
    Message::visit_signals([&](const char* signal, const char*, auto value, auto) {
        using Value = std::decay_t<decltype(Message{}.*value)>;
        if constexpr (std::is_enum_v<Value>) {
            const std::uint32_t identifier = Message::identifier | (Message::extended ? extended_bit : 0U);
            EXPECT_EQ((names_of<Message, Value>()), names_in(dbc, identifier, signal))
                << Message::name << "." << signal;
            ++enumerations;
        }
    });
    return enumerations;
}

TEST(EveryEnumeration, HasTheNamesOfTheDbcFile) {
    int enumerations = 0;
    rsi::can_dbc::visit_messages([&enumerations](auto type) {
        enumerations += expect_names_of_dbc<typename decltype(type)::Type>("can_dbc/rollover_warning.dbc");
    });
    EXPECT_EQ(enumerations, 9);
    enumerations = 0;
    byte_orders::visit_messages([&enumerations](auto type) {
        enumerations += expect_names_of_dbc<typename decltype(type)::Type>("tests/can_dbc/byte_orders.dbc");
    });
    EXPECT_EQ(enumerations, 1);
}

}  // namespace
}  // namespace every_message_test
