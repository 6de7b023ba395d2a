// Section authority: authenticates a parameter section and rejects a rollback to an older one.
//
// A sealed section carries, behind its CRC:
//
//   offset  bytes
//        0      4  magic, "RSIA"
//        4      4  version of the calibration, which only increases (anti-rollback counter)
//        8     16  AES-128-CMAC (RFC 4493) of every byte before, those of the section too
//
// Every number is little-endian, whatever the target. A firmware without authority reads a sealed section as
// any other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/hal/key_store.hpp"
#include "rsi/hal/storage.hpp"

namespace rsi::application {

namespace seal {

inline constexpr std::array<std::uint8_t, 4> magic{'R', 'S', 'I', 'A'};
inline constexpr std::size_t magic_at = section::length;
inline constexpr std::size_t version_at = magic_at + 4U;
inline constexpr std::size_t code_at = version_at + 4U;
inline constexpr std::size_t sealed_length = code_at + std::tuple_size<hal::AuthenticationCode>::value;

}  // namespace seal

// First error of a seal.
enum class SealFault : std::uint8_t {
    none,
    missing,       // the section has no seal
    forged,        // the CMAC does not match, or the key store does not answer
    outdated,      // a newer section has been in use
    version_lost,  // the stored version is damaged
};

// Protection of the parameters as receivers may assume it; sent as Protection.
enum class Protection : std::uint8_t {
    unsealed = 0,            // any writer of the memory can write the parameters
    unsealed_test_keys = 1,  // the same, and the keys of XCP or UDS are public
    sealed_test_keys = 2,    // a section must have a seal, by a public key
    sealed = 3,
};

class SectionAuthority {
 public:
    // Both must outlive this object. `newest` takes a record of access::stored_count_length bytes,
    // and is used by this object only.
    SectionAuthority(hal::KeyStore& keys, hal::Storage& newest) noexcept : keys_{keys}, newest_{newest} {}

    // Before the first cycle and before the other calls: reads the newest version that has been in use.
    [[gnu::cold]] void start() noexcept;

    // Check of the section at `bytes`, of whose memory `length` bytes may be read. Its content is not
    // examined.
    [[gnu::cold]] SealFault check(const std::uint8_t* bytes, std::size_t length) noexcept;

    // Stores the version of a section that passed check(): lower versions are outdated from now on. False if
    // the storage is busy; the version then stays as it was.
    [[gnu::cold]] bool raise(const std::uint8_t* bytes) noexcept;

    // The newest version that has been in use.
    std::uint32_t version() const noexcept { return version_; }

    const hal::KeyStore& keys() const noexcept { return keys_; }

 private:
    hal::KeyStore& keys_;
    hal::Storage& newest_;
    std::uint32_t version_{0U};
    bool is_readable_{false};
};

// Puts a seal behind the section at `bytes`, which have room for seal::sealed_length. False where the key
// store does not answer; the section is then unsealed.
[[gnu::cold]] bool seal_section(hal::KeyStore& keys, std::uint32_t version, std::uint8_t* bytes) noexcept;

// As read_parameter_section without an authority, and refused as `unauthentic` where the seal is not good.
// The authority's version stays as it is.
ParameterSectionAnswer read_parameter_section(const std::uint8_t* bytes, std::size_t length,
                                              SectionAuthority& authority,
                                              rsi::Parameters& parameters) noexcept;

}  // namespace rsi::application
