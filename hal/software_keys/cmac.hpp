// AES-128-CMAC: the authentication code of RFC 4493, over the block cipher of Mbed TLS. Mbed TLS has a CMAC
// of its own, which wants a heap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/hal/key_store.hpp"

namespace rsi::hal {

using Key = std::array<std::uint8_t, 16>;

// CMAC of `length` bytes. False where the library refuses; `code` is then left as it was.
bool cmac(const Key& key, const std::uint8_t* bytes, std::size_t length, AuthenticationCode& code) noexcept;

}  // namespace rsi::hal
