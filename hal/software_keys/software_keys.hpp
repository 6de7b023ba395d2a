// Software keys: a key store without hardware. Its keys lie in the program or in a file, where any reader of
// those finds them; a product has a hardware security module behind hal::KeyStore instead.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/software_keys/cmac.hpp"
#include "rsi/hal/key_store.hpp"

namespace rsi::hal {

inline constexpr std::size_t key_slots = 3U;
using Keys = std::array<Key, key_slots>;  // in the order of KeySlot

// A public key. They are for tests; an ECU that has them says so on the bus.
inline constexpr Keys test_keys{{
    {'t', 'e', 's', 't', ' ', 'k', 'e', 'y', ' ', 'f', 'o', 'r', ' ', 'X', 'C', 'P'},
    {'t', 'e', 's', 't', ' ', 'k', 'e', 'y', ' ', 'f', 'o', 'r', ' ', 'U', 'D', 'S'},
    {'t', 'e', 's', 't', ' ', 'k', 'e', 'y', ',', ' ', 's', 'e', 'c', 't', 'i', 'o'},
}};

class SoftwareKeys final : public KeyStore {
 public:
    explicit SoftwareKeys(const Keys& keys) noexcept : keys_{keys} {}

    bool authenticate(KeySlot slot, const std::uint8_t* bytes, std::size_t length,
                      AuthenticationCode& code) noexcept override;

    // True when any of them is a test key.
    bool has_test_keys() const noexcept override;

 private:
    Keys keys_;
};

}  // namespace rsi::hal
