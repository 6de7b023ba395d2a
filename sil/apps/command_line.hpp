// Command line: how rsi-sil and rsi-ecu begin and end, what they say when something is wrong, and checks of
// values.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace sil {

inline constexpr int usage_error_status = 2;

// The command line is wrong in a way that CLI11 does not know of.
class UsageError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// All that a program does, and its exit status. A request for help is answered on stdout. Errors go to stderr
// in one line "PROGRAM: cause", after a wrong command line (status 2) followed by the command
// that shows the help. Output that could not be written is a failure, too.
int run_program(const CLI::App& app, const std::function<void()>& work);

// On stderr. Without a reader nothing is lost that matters, so that is no error.
void tell(const std::string& text);

// A check for an option: empty when good, else what is wanted. CLI11's own range checks let NaN pass.
std::function<std::string(const std::string&)> number_within(double minimum, double maximum);

// Only decimal digits, 0 to 2^64 - 1.
std::optional<std::uint64_t> whole_number(const std::string& text);

std::string check_whole_number(const std::string& text);

// An option for a whole number; Value: std::uint64_t, or an optional one. Not CLI11's own conversion, which
// takes 010 for eight. `value` must live as long as `command`.
template <typename Value>
CLI::Option* add_whole_number(CLI::App& command, const std::string& name, Value& value,
                              const std::string& description) {
    return command
        .add_option_function<std::string>(
            name, [&value](const std::string& text) { value = *whole_number(text); }, description)
        ->check(check_whole_number)  // before the function
        ->type_name("UINT");
}

// The same for one that may be repeated.
CLI::Option* add_whole_numbers(CLI::App& command, const std::string& name, std::vector<std::uint64_t>& values,
                               const std::string& description);

// --port: where a page is served on 127.0.0.1; 0: a free one.
CLI::Option* add_port_option(CLI::App& command, std::uint64_t& port);

}  // namespace sil
