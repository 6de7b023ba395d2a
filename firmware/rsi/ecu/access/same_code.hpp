// Constant-time comparison of authentication codes.
#pragma once

#include "rsi/hal/key_store.hpp"

namespace rsi::access {

// Compares every byte, so that the time does not reveal the position of the first difference.
inline bool is_same_code(const hal::AuthenticationCode& a, const hal::AuthenticationCode& b) noexcept {
    std::uint32_t difference = 0U;
    for (std::size_t byte = 0U; byte < a.size(); ++byte) {
        difference |= static_cast<std::uint32_t>(a[byte]) ^ static_cast<std::uint32_t>(b[byte]);
    }
    return difference == 0U;
}

}  // namespace rsi::access
