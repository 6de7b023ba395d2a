// Comparison of authentication codes in a time that says nothing of where they differ.
#pragma once

#include "rsi/hal/key_store.hpp"

namespace rsi::access {

// Every byte is looked at, whatever those before were.
inline bool is_same_code(const hal::AuthenticationCode& a, const hal::AuthenticationCode& b) noexcept {
    std::uint32_t difference = 0U;
    for (std::size_t byte = 0U; byte < a.size(); ++byte) {
        difference |= static_cast<std::uint32_t>(a[byte]) ^ static_cast<std::uint32_t>(b[byte]);
    }
    return difference == 0U;
}

}  // namespace rsi::access
