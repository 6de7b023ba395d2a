// Stack use, from the pattern that start.S paints the stacks with.
#pragma once

#include <cstdint>

namespace hal::zynqmp_r5 {

inline constexpr std::uint32_t stack_pattern{0x5A5A'5A5AU};

// Bytes between `bottom` and `top` that have been written to, or lie above one that has. Whole words.
inline std::uint32_t stack_use(const std::uint32_t* bottom, const std::uint32_t* top) noexcept {
    const std::uint32_t* lowest = bottom;
    while (lowest != top && *lowest == stack_pattern) {
        ++lowest;
    }
    return static_cast<std::uint32_t>(top - lowest) * static_cast<std::uint32_t>(sizeof(std::uint32_t));
}

}  // namespace hal::zynqmp_r5
