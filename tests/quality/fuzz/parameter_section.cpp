// Parameter sections from any bytes, against a second reader: the first thing that is wrong is refused by its
// own code, nothing beyond the memory is read, and only what is good is taken over. An accepted section,
// written again by the tool that makes them, is the same. With required seals only a section sealed with the
// key, and not older than the last, is taken.
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "hal/memory/memory_storage.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/access/stored_count.hpp"
#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/ecu/application/section_authority.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/parameter_section_file.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/crc32.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/support/large_suv.h"

namespace {

namespace section = rsi::application::section;
using fuzz::ByteReader;
using fuzz::require;
using rsi::application::ParametersRefusal;

using Bytes = std::vector<std::uint8_t>;

std::uint32_t number_at(const Bytes& bytes, std::size_t at, std::size_t count) {
    std::uint32_t number = 0U;
    for (std::size_t index = count; index-- > 0U;) {
        number = number * 256U + bytes[at + index];
    }
    return number;
}

rsi::Parameters values_of(const Bytes& bytes) {
    rsi::Parameters parameters{};
    static_assert(sizeof parameters == 4U * section::value_count);
    std::memcpy(&parameters, bytes.data() + 64U, sizeof parameters);  // this machine is little-endian
    return parameters;
}

ParametersRefusal refusal_of(const Bytes& bytes) {
    if (bytes.size() < 4U || std::memcmp(bytes.data(), "RSIP", 4U) != 0) {
        return ParametersRefusal::missing;
    }
    if (bytes.size() < 64U) {
        return ParametersRefusal::length;
    }
    if (number_at(bytes, 4U, 2U) != 1U) {
        return ParametersRefusal::version;
    }
    if (number_at(bytes, 6U, 2U) != section::value_count || number_at(bytes, 8U, 4U) != section::layout) {
        return ParametersRefusal::layout;
    }
    const std::size_t length = 68U + 4U * section::value_count;
    if (bytes.size() < length || number_at(bytes, 12U, 4U) != length) {
        return ParametersRefusal::length;
    }
    if (number_at(bytes, length - 4U, 4U) != fuzz::crc32_by_division(bytes.data(), length - 4U)) {
        return ParametersRefusal::checksum;
    }
    return rsi::validate(values_of(bytes)).accepted == 1 ? ParametersRefusal::none : ParametersRefusal::value;
}

// Any bytes; or a good section with changes, with or without a check sum that fits them.
Bytes any_section(ByteReader& reader) {
    const unsigned kind = reader.below(4U);
    if (kind == 0U) {
        Bytes bytes(reader.take<std::uint16_t>() % 600U);
        reader.take_into(bytes.data(), bytes.size());
        return bytes;
    }
    static const Bytes good = sil::parameter_section(rsi_test_large_suv(), "large SUV");
    Bytes bytes = good;
    for (unsigned changes = reader.below(16U); changes > 0U; --changes) {
        const std::size_t at = reader.take<std::uint16_t>() % bytes.size();
        bytes[at] = reader.take<std::uint8_t>();
    }
    if (kind == 2U) {
        const std::uint32_t crc = fuzz::crc32_by_division(bytes.data(), section::checksum_at);
        std::memcpy(bytes.data() + section::checksum_at, &crc, sizeof crc);
    } else if (kind == 3U) {
        bytes.resize(reader.take<std::uint16_t>() % 600U);
    }
    bytes.shrink_to_fit();
    return bytes;
}

void check_written_again(const Bytes& bytes, const rsi::Parameters& parameters) {
    const std::string name = sil::section_name(bytes);
    Bytes again;
    try {
        again = sil::parameter_section(parameters, name);
    } catch (const sil::InputError&) {
        return;  // a name that the tool would not write
    }
    Bytes expected{bytes.begin(), bytes.begin() + section::length};
    for (std::size_t at = 16U + name.size(); at < 64U; ++at) {
        expected[at] = 0U;  // behind the name's end there may be anything
    }
    const std::uint32_t crc = fuzz::crc32_by_division(expected.data(), section::checksum_at);
    std::memcpy(expected.data() + section::checksum_at, &crc, sizeof crc);
    require(again == expected, "the tool writes the same section");
}

constexpr rsi::hal::Key key{1U, 2U, 3U};

// Sealed with the key, with another or not at all, with or without a change behind it; then the version that
// was in use before.
void check_seal(ByteReader& reader, const Bytes& any, ParametersRefusal refusal) {
    Bytes bytes = any;
    bool good = reader.below(4U) != 0U && bytes.size() >= section::length;
    const auto version = reader.take<std::uint32_t>();
    if (good) {
        bytes.resize(section::length);
        const bool is_own = reader.below(4U) != 0U;
        bytes = sil::sealed(bytes, version, is_own ? key : rsi::hal::Key{});
        const std::size_t at = reader.take<std::uint16_t>() % bytes.size();
        const auto change =
            static_cast<std::uint8_t>(reader.below(2U) == 0U ? 0U : reader.take<std::uint8_t>());
        bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ change);
        good = is_own && change == 0U;
    }
    bytes.shrink_to_fit();
    rsi::hal::Keys keys{};
    keys[static_cast<std::size_t>(rsi::hal::KeySlot::parameters)] = key;
    rsi::hal::SoftwareKeys store{keys};
    rsi::hal::MemoryStorage<rsi::access::stored_count_length> newest;
    rsi::application::SectionAuthority authority{store, newest};
    const auto before = reader.take<std::uint32_t>();
    Bytes used(rsi::application::seal::sealed_length);
    require(rsi::application::seal_section(store, before, used.data()), "the store answers");
    authority.start();
    require(authority.raise(used.data()) && authority.version() == before, "the storage takes the version");

    rsi::Parameters parameters{};
    const ParametersRefusal answer =
        rsi::application::read_parameter_section(bytes.data(), bytes.size(), authority, parameters).refusal;
    const bool accepted = answer == ParametersRefusal::none;
    require(accepted == (good && version >= before && refusal == ParametersRefusal::none),
            "what is sealed and new is taken, and nothing else");
    require(authority.version() == before, "looking raises nothing");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ByteReader reader{data, size};
    const Bytes bytes = any_section(reader);
    rsi::Parameters parameters;
    std::memset(&parameters, 0x55, sizeof parameters);
    const rsi::Parameters before = parameters;
    const rsi::application::ParameterSectionAnswer answer =
        rsi::application::read_parameter_section(bytes.data(), bytes.size(), parameters);

    require(answer.refusal == refusal_of(bytes), "the first thing that is wrong is the reason");
    const bool accepted = answer.refusal == ParametersRefusal::none;
    require((answer.validation.accepted == 1) == accepted, "the validation agrees with the refusal");
    require((answer.refusal == ParametersRefusal::value) == (std::strlen(answer.validation.field) > 0U),
            "a refused value is named, and nothing else is");
    const rsi::Parameters expected = accepted ? values_of(bytes) : before;
    require(std::memcmp(&parameters, &expected, sizeof expected) == 0,
            "the parameters are those of the section, or left alone");
    require(accepted || !sil::explain(answer).empty(), "a refusal is explained");
    if (accepted) {
        check_written_again(bytes, parameters);
    }
    check_seal(reader, bytes, answer.refusal);
    return 0;
}
