// A second reader of the DBC file, which shares nothing with the generator and its codec: it reads bit by bit
// and computes in double.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace fuzz {

struct DbcSignal {
    unsigned start_bit{0U};
    unsigned length{0U};
    bool little_endian{true};
    bool is_signed{false};
    double factor{1.0};
    double offset{0.0};
    double minimum{0.0};
    double maximum{0.0};
    std::int64_t start_value{0};
    std::optional<std::int64_t> not_available{};
    std::set<std::int64_t> named{};  // every other code of the VAL_ line
    std::vector<unsigned> places{};  // of its bits in the payload, from the least significant one on

    // The code in a payload that reaches to the signal's last byte.
    std::int64_t raw(const std::uint8_t* payload) const;
    double physical(std::int64_t raw) const { return static_cast<double>(raw) * factor + offset; }
    // Whether a number lies within the range, give or take what decimals lose in binary.
    bool admits(double value) const;
    // The payload's bits that belong to the signal.
    std::uint64_t mask() const;
};

struct DbcMessage {
    std::size_t length{0U};
    std::map<std::string, DbcSignal> signals{};
};

// By name of the message. Ends the program when the file cannot be read.
std::map<std::string, DbcMessage> read_dbc(const std::string& path);

}  // namespace fuzz
