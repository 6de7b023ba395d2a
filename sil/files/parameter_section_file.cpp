#include "sil/files/parameter_section_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "hal/memory/memory_storage.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/application/little_endian.hpp"
#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"

namespace sil {
namespace {

namespace section = rsi::application::section;

void put(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint32_t value, std::size_t count) {
    for (std::size_t index = 0U; index < count; ++index) {
        bytes[at + index] = static_cast<std::uint8_t>(value >> (8U * index));
    }
}

template <typename Value>
std::uint32_t bits_of(Value value) {
    static_assert(sizeof(Value) == sizeof(std::uint32_t));
    std::uint32_t bits = 0U;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

void put_name(std::vector<std::uint8_t>& bytes, std::string_view name) {
    const auto printable = [](char letter) { return letter >= ' ' && letter <= '~'; };
    if (name.size() > section::name_length || !std::all_of(name.begin(), name.end(), printable)) {
        throw InputError(fmt::format(
            "the name \"{}\" does not fit into the section: at most {} printable ASCII characters, given by "
            "--name TEXT",
            name, section::name_length));
    }
    std::copy(name.begin(), name.end(), bytes.begin() + section::name_at);
}

// The other slots are of no use here.
rsi::hal::Keys with_parameters_key(const rsi::hal::Key& key) {
    rsi::hal::Keys keys{};
    keys[static_cast<std::size_t>(rsi::hal::KeySlot::parameters)] = key;
    return keys;
}

std::string hex_record(std::uint8_t type, std::uint32_t address, const std::uint8_t* data,
                       std::size_t count) {
    std::vector<std::uint8_t> record{static_cast<std::uint8_t>(count),
                                     static_cast<std::uint8_t>((address >> 8U) & 0xFFU),
                                     static_cast<std::uint8_t>(address & 0xFFU), type};
    record.insert(record.end(), data, data + count);
    const unsigned sum = std::accumulate(record.begin(), record.end(), 0U);
    record.push_back(static_cast<std::uint8_t>(0U - sum));
    std::string text = ":";
    for (const std::uint8_t byte : record) {
        text += fmt::format("{:02X}", byte);
    }
    return text + "\n";
}

}  // namespace

std::vector<std::uint8_t> parameter_section(const rsi::Parameters& parameters, std::string_view name) {
    std::vector<std::uint8_t> bytes(section::length, std::uint8_t{0U});
    std::copy(std::begin(section::magic), std::end(section::magic), bytes.begin());
    put(bytes, section::version_at, section::format_version, 2U);
    put(bytes, section::count_at, section::value_count, 2U);
    put(bytes, section::layout_at, section::layout, 4U);
    put(bytes, section::length_at, section::length, 4U);
    put_name(bytes, name);
    std::size_t at = section::values_at;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        put(bytes, at, bits_of(parameters.*field.member), 4U);
        at += 4U;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        put(bytes, at, bits_of(parameters.*field.member), 4U);
        at += 4U;
    }
    put(bytes, section::checksum_at, rsi::application::crc32(bytes.data(), section::checksum_at), 4U);
    return bytes;
}

std::vector<std::uint8_t> sealed(const std::vector<std::uint8_t>& section, std::uint32_t version,
                                 const rsi::hal::Key& key) {
    std::vector<std::uint8_t> bytes = section;
    bytes.resize(rsi::application::seal::sealed_length);
    rsi::hal::SoftwareKeys keys{with_parameters_key(key)};
    if (!rsi::application::seal_section(keys, version, bytes.data())) {
        throw std::logic_error("the key store in software has not answered");
    }
    return bytes;
}

bool is_sealed(const std::vector<std::uint8_t>& section) {
    const auto& magic = rsi::application::seal::magic;
    return section.size() >= rsi::application::seal::sealed_length &&
           std::equal(magic.begin(), magic.end(), section.begin() + rsi::application::seal::magic_at);
}

std::uint32_t sealed_version(const std::vector<std::uint8_t>& section) {
    return rsi::application::u32_at(section.data(), rsi::application::seal::version_at);
}

rsi::application::SealFault seal_fault(const std::vector<std::uint8_t>& section, const rsi::hal::Key& key) {
    rsi::hal::SoftwareKeys keys{with_parameters_key(key)};
    rsi::hal::MemoryStorage<1U> nothing;
    rsi::application::SectionAuthority authority{keys, nothing};
    authority.start();
    return authority.check(section.data(), section.size());
}

std::string section_name(const std::vector<std::uint8_t>& bytes) {
    const auto begin = bytes.begin() + section::name_at;
    return {begin, std::find(begin, begin + section::name_length, std::uint8_t{0U})};
}

std::string intel_hex(const std::vector<std::uint8_t>& bytes, std::uint32_t address) {
    constexpr std::size_t bytes_a_record = 16U;
    constexpr std::uint32_t segment = 0x1'0000U;
    if (address > 0xFFFF'FFFFU - (bytes.size() - 1U)) {
        throw InputError(
            fmt::format("{} bytes from address {:#x} on go beyond the last address", bytes.size(), address));
    }
    std::string text;
    std::size_t at = 0U;
    while (at < bytes.size()) {
        const std::uint32_t here = address + static_cast<std::uint32_t>(at);
        if (at == 0U || here % segment == 0U) {
            const std::uint8_t upper[2] = {static_cast<std::uint8_t>(here >> 24U),
                                           static_cast<std::uint8_t>((here >> 16U) & 0xFFU)};
            text += hex_record(4U, 0U, upper, sizeof upper);
        }
        // No record may cross from one segment of 64 KiB into the next.
        const std::size_t count =
            std::min({bytes_a_record, bytes.size() - at, std::size_t{segment - here % segment}});
        text += hex_record(0U, here, bytes.data() + at, count);
        at += count;
    }
    return text + hex_record(1U, 0U, nullptr, 0U);
}

std::string section_source(const std::vector<std::uint8_t>& bytes) {
    std::string text = fmt::format(
        "/* Parameter section of the calibration \"{}\", made by `rsi-sil parameters --format c`; do not "
        "edit.\n"
        " * firmware/rsi/ecu/application/parameter_section.hpp says what is where, docs/calibration.md how "
        "to change "
        "it. "
        "*/\n"
        "__attribute__((section(\".parameters\"), used, aligned(4)))\n"
        "const unsigned char rsi_parameter_section[{}] = {{\n",
        section_name(bytes), bytes.size());
    constexpr std::size_t bytes_a_line = 16U;
    for (std::size_t at = 0U; at < bytes.size(); at += bytes_a_line) {
        text += "   ";
        for (std::size_t index = at; index < std::min(at + bytes_a_line, bytes.size()); ++index) {
            text += fmt::format(" 0x{:02X},", bytes[index]);
        }
        text += "\n";
    }
    return text + "};\n";
}

std::string calibration_toml(const rsi::Parameters& parameters) {
    std::string text;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        // With a point, because "-0" would be read as an integer, which has no sign then.
        const float value = parameters.*field.member;
        const bool is_zero = !(value < 0.0F) && !(value > 0.0F);
        text += field.name + (is_zero ? fmt::format(" = {:#}\n", value) : fmt::format(" = {}\n", value));
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        text += fmt::format("{} = \"{}\"\n", field.name, field.choices[parameters.*field.member]);
    }
    return text;
}

std::string calibration_header(const rsi::Parameters& parameters, std::string_view name) {
    const auto fits = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '_';
    };
    if (name.empty() || (name[0] >= '0' && name[0] <= '9') || !std::all_of(name.begin(), name.end(), fits)) {
        throw InputError(fmt::format(
            "\"{}\" is no identifier of C, which a header needs as a name; give one by --name TEXT", name));
    }
    std::string text = fmt::format(
        "/* The calibration \"{}\" as C99, made by `rsi-sil parameters --format h`; do not edit. */\n"
        "#include \"rsi/rsi.h\"\n\n"
        "static const rsi_parameters {}_parameters = {{\n",
        name, name);
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        text += fmt::format("    .{} = {:#}F,\n", field.name, parameters.*field.member);
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        const std::int32_t value = parameters.*field.member;
        text += fmt::format("    .{} = {}, /* {} */\n", field.name, value, field.choices[value]);
    }
    return text + "};\n";
}

std::string explain(const rsi::application::ParameterSectionAnswer& answer) {
    using rsi::application::ParametersRefusal;
    constexpr const char* write_anew = "write it anew from its TOML file with the rsi-sil of that firmware";
    switch (answer.refusal) {
        case ParametersRefusal::none:
            return "nothing is wrong with it";
        case ParametersRefusal::missing:
            return "it is no parameter section: it does not begin with RSIP. Is it a raw binary, cut out at "
                   "the "
                   "right address?";
        case ParametersRefusal::version:
            return fmt::format("its format version is not {}; {}", section::format_version, write_anew);
        case ParametersRefusal::layout:
            return fmt::format("it was written for another set of parameters; {}", write_anew);
        case ParametersRefusal::length:
            return fmt::format("it is not {} bytes long; copy it whole, or {}", section::length, write_anew);
        case ParametersRefusal::checksum:
            return fmt::format("its CRC-32 is wrong: a byte has changed; {}", write_anew);
        case ParametersRefusal::value:
            return fmt::format("\"{}\" {}; correct it in the TOML file and write the section anew",
                               answer.validation.field, answer.validation.reason);
        case ParametersRefusal::unauthentic:
            return "it has no good seal; seal it: --key FILE --section-version N";
    }
    return "unknown refusal";
}

std::string explain(rsi::application::SealFault fault) {
    using rsi::application::SealFault;
    switch (fault) {
        case SealFault::none:
            return "its seal is good";
        case SealFault::missing:
            return "it has no seal; write it with --key FILE --section-version N";
        case SealFault::forged:
            return "its seal is of another key, or a byte has changed; seal it with the key of that control "
                   "unit";
        case SealFault::outdated:
            return "a newer version has been in use; seal it with a higher --section-version";
        case SealFault::version_lost:
            return "which version has been in use cannot be read any more; the control unit needs service";
    }
    return "unknown fault of a seal";
}

}  // namespace sil
