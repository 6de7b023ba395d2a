// Lines of candump logs without streams, heap or exceptions: what a test on a bare target reads and writes.
//
// Only classic data frames with a standard identifier, as all of the firmware's are:
//     (seconds.microseconds) interface ID#DATA
// sil/files/candump_log.hpp is the full reader, on a host.
#pragma once

#include <cstddef>

#include "rsi/hal/can_bus.hpp"

namespace target {

inline constexpr std::size_t longest_interface_name = 15U;  // of Linux
inline constexpr std::size_t longest_line = 80U;

struct CandumpLine {
    rsi::hal::CanFrame frame;  // receive_time is the time of the line
    char interface[longest_interface_name + 1U];
};

// `text` ends with a zero and has no line feed. False when it is no such line; `line` is then incomplete.
bool parse_line(const char* text, CandumpLine& line);

// Writes the line with a line feed and no zero; returns its length. No time may be negative.
std::size_t format_line(const CandumpLine& line, char (&text)[longest_line]);

// The value of `digits` hexadecimal digits (1 to 8) at `text`; false when one is none. Capital letters only.
bool parse_hexadecimal(const char* text, std::size_t digits, std::uint32_t& value);

}  // namespace target
