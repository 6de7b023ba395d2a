#include "sil/apps/parameters_command.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "sil/files/calibration_file.hpp"
#include "sil/files/parameter_section_file.hpp"
#include "sil/files/whole_file.hpp"

namespace sil {
namespace {

struct ParametersRequest {
    std::string calibration_file;
    std::vector<std::string> changes;
    std::filesystem::path output;
    std::string format{"bin"};
    std::uint32_t address{0U};
    std::string name;
    std::filesystem::path checked;
};

std::optional<std::uint32_t> address(std::string_view text) {
    const bool is_hexadecimal = text.substr(0U, 2U) == "0x";
    if (is_hexadecimal) {
        text.remove_prefix(2U);
    }
    std::uint32_t value = 0U;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value, is_hexadecimal ? 16 : 10);
    return error == std::errc{} && rest == end ? std::optional{value} : std::nullopt;
}

std::string content_of(const ParametersRequest& request, const rsi::Parameters& parameters,
                       const std::string& name) {
    if (request.format == "h") {
        return calibration_header(parameters, name);
    }
    const std::vector<std::uint8_t> section = parameter_section(parameters, name);
    if (request.format == "hex") {
        return intel_hex(section, request.address);
    }
    if (request.format == "c") {
        return section_source(section);
    }
    return {section.begin(), section.end()};
}

void write_section(const ParametersRequest& request) {
    const rsi::Parameters parameters = load_calibration(request.calibration_file, request.changes);
    const std::string name =
        request.name.empty() ? std::filesystem::path{request.calibration_file}.stem().string() : request.name;
    write_file_atomically(request.output, content_of(request, parameters, name));
    fmt::print("{}: calibration \"{}\"\n", request.output.string(), name);
}

void check_section(const std::filesystem::path& path) {
    const std::string content = read_whole_file(path);
    const std::vector<std::uint8_t> bytes{content.begin(), content.end()};
    rsi::Parameters parameters{};
    const application::ParameterSectionAnswer answer =
        application::read_parameter_section(bytes.data(), bytes.size(), parameters);
    if (answer.refusal != application::ParametersRefusal::none) {
        throw std::runtime_error(
            fmt::format("{}: the firmware would refuse it: {}", path.string(), explain(answer)));
    }
    fmt::print("# {}: the firmware takes it; calibration \"{}\"\n{}", path.string(), section_name(bytes),
               calibration_toml(parameters));
}

}  // namespace

void add_parameters_command(CLI::App& app) {
    const auto request = std::make_shared<ParametersRequest>();
    CLI::App* command = app.add_subcommand(
        "parameters",
        "Write the parameter section of an image from a calibration, or say what is in one (--check)");
    CLI::Option* calibration =
        command->add_option("--parameters", request->calibration_file, "Calibration of the component (TOML)");
    CLI::Option* output =
        command->add_option("--output", request->output, "File for the section")->needs(calibration);
    calibration->needs(output);
    command
        ->add_option("--set", request->changes,
                     "KEY=VALUE in place of what the calibration says; may be repeated")
        ->allow_extra_args(false)
        ->needs(calibration);
    CLI::Option* format = command
                              ->add_option("--format", request->format,
                                           "bin: the bytes; hex: Intel HEX at --address; c: the section as a "
                                           "source for the image's build; "
                                           "h: rsi_parameters as a C99 header, no section")
                              ->check(CLI::IsMember({"bin", "hex", "c", "h"}))
                              ->capture_default_str()
                              ->needs(output);
    command
        ->add_option_function<std::string>(
            "--address",
            [request](const std::string& text) {
                request->address = address(text).value_or(request->address);
            },
            "Where the section lies in memory, for example 0x00180000")
        ->check([](const std::string& text) {
            return address(text)
                       ? std::string{}
                       : fmt::format("wants an address of 32 bits, decimal or as 0x00180000, not {}", text);
        })
        ->type_name("UINT")
        ->needs(format);
    command->add_option("--name", request->name, "Name in the section (default: the file's)")->needs(output);
    CLI::Option* check =
        command->add_option("--check", request->checked, "Section as raw bytes: would the firmware take it?");
    check->excludes(calibration)->excludes(output);
    command->callback([request, calibration, check] {
        if (!*calibration && !*check) {
            throw CLI::RequiredError("--parameters FILE.toml with --output FILE.bin, or --check FILE.bin,");
        }
        if (*check) {
            check_section(request->checked);
        } else {
            write_section(*request);
        }
    });
}

}  // namespace sil
