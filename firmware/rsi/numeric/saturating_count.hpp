// A counter that stays at its largest value.
#pragma once

#include <cstdint>

namespace rsi {

constexpr void count_up(std::uint32_t& counter) {
    if (counter < UINT32_MAX) {
        ++counter;
    }
}

}  // namespace rsi
