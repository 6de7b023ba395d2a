// Memory word: four bytes of an object as they stand in memory.
#pragma once

#include <cstdint>
#include <cstring>

namespace rsi::monitoring {

using MemoryWord = std::uint32_t;

inline MemoryWord memory_word_at(const unsigned char* bytes) noexcept {
    MemoryWord word{};
    std::memcpy(&word, bytes, sizeof(word));
    return word;
}

}  // namespace rsi::monitoring
