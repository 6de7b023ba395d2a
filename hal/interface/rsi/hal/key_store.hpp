// Key store: AES-128 keys that are used and never read. A product has them in a hardware security module.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rsi::hal {

// Each purpose has a key of its own, so that no answer for one is of use for another.
enum class KeySlot : std::uint8_t {
    calibration = 0,  // XCP: seed and key
    diagnosis = 1,    // UDS: seed and key
    parameters = 2,   // the parameter section's authentication code
};

using AuthenticationCode = std::array<std::uint8_t, 16>;

class KeyStore {
 public:
    KeyStore(const KeyStore&) = delete;
    KeyStore& operator=(const KeyStore&) = delete;

    // Fills `code` with the AES-128-CMAC (RFC 4493) of `length` bytes under the key in `slot`; false where
    // the slot is empty or the store does not answer, and then `code` means nothing.
    virtual bool authenticate(KeySlot slot, const std::uint8_t* bytes, std::size_t length,
                              AuthenticationCode& code) noexcept = 0;

    // True for the public keys, for tests.
    virtual bool has_test_keys() const noexcept = 0;

 protected:
    KeyStore() = default;
    ~KeyStore() = default;
};

}  // namespace rsi::hal
