// Output digest: one number over all floats that the component gave, to see that two machines gave the same.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "rsi/rsi.h"

namespace budgets {

// FNV-1a over the words, begun with fnv_offset.
inline constexpr uint32_t fnv_offset = 2166136261U;

inline uint32_t digest(uint32_t before, const rsi_outputs& outputs) {
    constexpr size_t begin = offsetof(rsi_outputs, warning_level);  // floats from here to the end
    uint32_t value = before;
    for (size_t at = begin; at < sizeof(rsi_outputs); at += sizeof(uint32_t)) {
        uint32_t word;
        memcpy(&word, reinterpret_cast<const unsigned char*>(&outputs) + at, sizeof(word));
        value = (value ^ word) * 16777619U;
    }
    return (value ^ static_cast<uint32_t>(outputs.state)) * 16777619U;
}

}  // namespace budgets
