// Fingerprint of a text: finds a change by accident, no deliberate forgery.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace sil {

// FNV-1a, 16 hexadecimal digits.
inline std::string fingerprint_of(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char letter : text) {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001B3U;
    }
    return fmt::format("{:016x}", hash);
}

}  // namespace sil
