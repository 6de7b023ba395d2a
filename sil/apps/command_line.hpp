// Command line: what rsi-sil and rsi-ecu say when theirs is wrong, and checks of values.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace sil {

inline constexpr int usage_error_status = 2;

// Returns the exit status. A request for help is answered on stdout; what is wrong is said on stderr in one
// line "PROGRAM: cause", followed by the command that shows the help.
int report(const CLI::App& app, const CLI::ParseError& error);

// The same for a cause that CLI11 does not know of.
int report_usage_error(const CLI::App& app, const std::string& cause);

// A check for an option: empty when good, else what is wanted. CLI11's own range checks let NaN pass.
std::function<std::string(const std::string&)> number_within(double minimum, double maximum);

// Only decimal digits, 0 to 2^64 - 1.
std::optional<std::uint64_t> whole_number(const std::string& text);

std::string check_whole_number(const std::string& text);

}  // namespace sil
