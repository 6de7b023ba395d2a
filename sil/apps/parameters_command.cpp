#include "sil/apps/commands.hpp"

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
#include "sil/files/file_io.hpp"
#include "sil/files/key_file.hpp"
#include "sil/files/parameter_section_file.hpp"

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
    std::filesystem::path key;
    std::optional<std::uint32_t> section_version;
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

// A key that others can read is none any more.
rsi::hal::Key section_key(const ParametersRequest& request) {
    namespace fs = std::filesystem;
    const rsi::hal::Key key = load_key(request.key, rsi::hal::KeySlot::parameters);
    std::error_code ignored;
    const fs::perms others = fs::perms::group_read | fs::perms::others_read;
    if (request.key == test_key_name) {
        fmt::print(stderr, "rsi-sil: the test key is public; no vehicle may have a control unit with it\n");
    } else if ((fs::status(request.key, ignored).permissions() & others) != fs::perms::none) {
        fmt::print(stderr, "rsi-sil: others can read {0}; chmod 600 {0}\n", request.key.string());
    }
    return key;
}

std::string content_of(const ParametersRequest& request, const rsi::Parameters& parameters,
                       const std::string& name) {
    if (request.format == "h") {
        return calibration_header(parameters, name);
    }
    std::vector<std::uint8_t> section = parameter_section(parameters, name);
    if (request.section_version) {
        section = sealed(section, *request.section_version, section_key(request));
    }
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

// A line about the seal, if there is one or a key to check it. Throws when it is not good.
std::string about_seal(const ParametersRequest& request, const std::vector<std::uint8_t>& bytes) {
    if (request.key.empty()) {
        return is_sealed(bytes) ? fmt::format("# sealed as version {}; give --key FILE to check the seal\n",
                                              sealed_version(bytes))
                                : std::string{};
    }
    const rsi::application::SealFault fault = seal_fault(bytes, section_key(request));
    if (fault != rsi::application::SealFault::none) {
        throw std::runtime_error(fmt::format("{}: a firmware that wants a seal would refuse it: {}",
                                             request.checked.string(), explain(fault)));
    }
    return fmt::format("# sealed as version {} with that key\n", sealed_version(bytes));
}

void check_section(const ParametersRequest& request) {
    const std::filesystem::path& path = request.checked;
    const std::string content = read_whole_file(path);
    const std::vector<std::uint8_t> bytes{content.begin(), content.end()};
    rsi::Parameters parameters{};
    const rsi::application::ParameterSectionAnswer answer =
        rsi::application::read_parameter_section(bytes.data(), bytes.size(), parameters);
    if (answer.refusal != rsi::application::ParametersRefusal::none) {
        throw std::runtime_error(
            fmt::format("{}: the firmware would refuse it: {}", path.string(), explain(answer)));
    }
    fmt::print("# {}: the firmware takes it; calibration \"{}\"\n{}{}", path.string(), section_name(bytes),
               about_seal(request, bytes), calibration_toml(parameters));
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
            "Address of the section in memory, for example 0x00180000")
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
    CLI::Option* key = command->add_option("--key", request->key,
                                           "Key file (TOML: parameters = \"32 hexadecimal digits\") for the "
                                           "section's seal, or the word \"test\" for "
                                           "the public test key");
    CLI::Option* version =
        command
            ->add_option("--section-version", request->section_version,
                         "Version in the seal: a control unit refuses one that is lower than before")
            ->needs(key)
            ->needs(output)
            ->excludes(check);
    command->callback([request, calibration, check, key, version] {
        if (!*calibration && !*check) {
            throw CLI::RequiredError("--parameters FILE.toml with --output FILE.bin, or --check FILE.bin,");
        }
        if (*key && !*version && !*check) {
            throw CLI::RequiredError("--section-version N, which goes with --key and --output,");
        }
        if (*version && request->format == "h") {
            throw CLI::ValidationError("--section-version",
                                       "a header (--format h) is no section and has no seal");
        }
        if (*check) {
            check_section(*request);
        } else {
            write_section(*request);
        }
    });
}

}  // namespace sil
