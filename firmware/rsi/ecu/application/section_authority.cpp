#include "rsi/ecu/application/section_authority.hpp"

#include "rsi/ecu/access/same_code.hpp"
#include "rsi/ecu/access/stored_count.hpp"
#include "rsi/ecu/application/little_endian.hpp"

namespace rsi::application {
namespace {

bool has_seal(const std::uint8_t* bytes, std::size_t length) {
    bool same = (length >= seal::sealed_length);
    for (std::size_t index = 0U; same && (index < seal::magic.size()); ++index) {
        same = (bytes[seal::magic_at + index] == seal::magic[index]);
    }
    return same;
}

}  // namespace

// No record: a new control unit, version 0. A damaged record: the version is unknown, so every section is
// refused.
void SectionAuthority::start() noexcept {
    version_ = 0U;
    is_readable_ = (access::read_count(newest_, access::CountOf::section_versions, version_) !=
                    access::CountState::damaged);
}

SealFault SectionAuthority::check(const std::uint8_t* bytes, std::size_t length) noexcept {
    if (!has_seal(bytes, length)) {
        return SealFault::missing;
    }
    hal::AuthenticationCode given{};
    for (std::size_t byte = 0U; byte < given.size(); ++byte) {
        given[byte] = bytes[seal::code_at + byte];
    }
    hal::AuthenticationCode code{};
    if (!keys_.authenticate(hal::KeySlot::parameters, bytes, seal::code_at, code) ||
        !access::is_same_code(given, code)) {
        return SealFault::forged;
    }
    if (!is_readable_) {
        return SealFault::version_lost;
    }
    return (u32_at(bytes, seal::version_at) < version_) ? SealFault::outdated : SealFault::none;
}

bool SectionAuthority::raise(const std::uint8_t* bytes) noexcept {
    const std::uint32_t version = u32_at(bytes, seal::version_at);
    if (version == version_) {
        return true;
    }
    const bool stored = access::write_count(newest_, access::CountOf::section_versions, version);
    if (stored) {
        version_ = version;
    }
    return stored;
}

bool seal_section(hal::KeyStore& keys, std::uint32_t version, std::uint8_t* bytes) noexcept {
    put_u32(bytes, seal::magic_at, u32_at(seal::magic.data(), 0U));
    put_u32(bytes, seal::version_at, version);
    hal::AuthenticationCode code{};
    const bool answered = keys.authenticate(hal::KeySlot::parameters, bytes, seal::code_at, code);
    if (!answered) {
        put_u32(bytes, seal::magic_at, 0U);
    }
    for (std::size_t byte = 0U; byte < code.size(); ++byte) {
        bytes[seal::code_at + byte] = code[byte];
    }
    return answered;
}

ParameterSectionAnswer read_parameter_section(const std::uint8_t* bytes, std::size_t length,
                                              SectionAuthority& authority,
                                              rsi::Parameters& parameters) noexcept {
    rsi::Parameters read{};
    ParameterSectionAnswer answer = read_parameter_section(bytes, length, read);
    if (answer.refusal == ParametersRefusal::none) {
        if (authority.check(bytes, length) == SealFault::none) {
            parameters = read;
        } else {
            answer = ParameterSectionAnswer{ParametersRefusal::unauthentic, rsi::Validation{0, "", ""}};
        }
    }
    return answer;
}

}  // namespace rsi::application
