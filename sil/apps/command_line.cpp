// Command line: one-line causes from CLI11's exceptions.
#include "sil/apps/command_line.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <system_error>
#include <vector>

#include "sil/files/standard_streams.hpp"

namespace sil {
namespace {

constexpr std::uint64_t largest_port = 65535U;

// The subcommand that the words led to, or the program itself.
const CLI::App& innermost(const CLI::App& app) {
    const std::vector<CLI::App*> parsed = app.get_subcommands();
    return parsed.empty() ? app : *parsed.back();
}

std::string options_of(const CLI::App& app) {
    std::string names;
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_lnames().empty()) {
            names += " --" + option->get_lnames().front();
        }
    }
    return names;
}

std::string commands_of(const CLI::App& app) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names += " " + command->get_name();
    }
    return names;
}

std::string cause_of_surplus(const CLI::App& app, const std::string& word) {
    const CLI::App& command = innermost(app);
    if (word.size() > 1U && word.front() == '-') {
        return fmt::format("unknown option {}; there are:{}", word, options_of(command));
    }
    if (&command == &app) {
        return fmt::format("unknown command {}; there are:{}", word, commands_of(app));
    }
    return fmt::format("{} is one argument too many for {}", word, command.get_name());
}

std::string cause_of(const CLI::App& app, const CLI::ParseError& error) {
    // A word that is not understood explains more than what is missed because of it.
    const std::vector<std::string> surplus = app.remaining(true);
    if (!surplus.empty()) {
        return cause_of_surplus(app, surplus.front());
    }
    const std::string text = error.what();
    if (error.get_name() == "ArgumentMismatch") {
        return fmt::format("option {} needs one value", text.substr(0U, text.find(':')));
    }
    if (error.get_name() == "RequiredError" && app.get_require_subcommand_min() > 0U &&
        app.get_subcommands().empty()) {
        return fmt::format("a command is missing; there are:{}", commands_of(app));
    }
    return text;
}

int usage_error(const CLI::App& app, const std::string& cause) {
    const CLI::App& command = innermost(app);
    const std::string words =
        &command == &app ? app.get_name() : fmt::format("{} {}", app.get_name(), command.get_name());
    tell(fmt::format("{}: {}\nTry: {} --help\n", app.get_name(), cause, words));
    return usage_error_status;
}

int failure(const CLI::App& app, const std::string& cause) {
    tell(fmt::format("{}: {}\n", app.get_name(), cause));
    return 1;
}

int status_of(const CLI::App& app, const std::function<void()>& work) {
    try {
        work();
        return 0;
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? app.exit(error) : usage_error(app, cause_of(app, error));
    } catch (const UsageError& error) {
        return usage_error(app, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return failure(app, fmt::format("{}: {}; check the path and the permissions", error.path1().string(),
                                        error.code().message()));
    } catch (const std::system_error& error) {
        // fmt's when stdout cannot be written, of which the program's end tells.
        return std::ferror(stdout) != 0 ? 1 : failure(app, error.what());
    } catch (const std::bad_alloc&) {
        return failure(app, "there is not enough memory for this; give less at a time");
    } catch (const std::exception& error) {
        return failure(app, error.what());
    }
}

}  // namespace

int run_program(const CLI::App& app, const std::function<void()>& work) {
    occupy_closed_streams();
    const int status = status_of(app, work);
    const int lost = finish_output(app.get_name());
    return status == 0 ? lost : status;
}

void tell(const std::string& text) {
    static_cast<void>(std::fputs(text.c_str(), stderr));
}

std::function<std::string(const std::string&)> number_within(double minimum, double maximum) {
    return [=](const std::string& text) {
        double value = 0.0;
        const bool is_good = CLI::detail::lexical_cast(text, value) && value >= minimum && value <= maximum;
        return is_good ? std::string{}
                       : fmt::format("wants a number from {} to {}, not {}", minimum, maximum, text);
    };
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
    std::uint64_t value = 0U;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && rest == end ? std::optional{value} : std::nullopt;
}

std::string check_whole_number(const std::string& text) {
    return whole_number(text) ? std::string{}
                              : fmt::format("wants a whole number from 0 to {}, not {}",
                                            std::numeric_limits<std::uint64_t>::max(), text);
}

CLI::Option* add_whole_numbers(CLI::App& command, const std::string& name, std::vector<std::uint64_t>& values,
                               const std::string& description) {
    return command
        .add_option_function<std::vector<std::string>>(
            name,
            [&values](const std::vector<std::string>& texts) {
                values.clear();
                for (const std::string& text : texts) {
                    values.push_back(*whole_number(text));
                }
            },
            description)
        ->allow_extra_args(false)
        ->check(check_whole_number)
        ->type_name("UINT");
}

CLI::Option* add_port_option(CLI::App& command, std::uint64_t& port) {
    return add_whole_number(command, "--port", port, "On 127.0.0.1 (default: a free one)")
        ->check([](const std::string& text) -> std::string {
            return whole_number(text).value_or(largest_port + 1U) <= largest_port
                       ? std::string{}
                       : fmt::format("wants a whole number from 0 to {}, not {}", largest_port, text);
        });
}

}  // namespace sil
