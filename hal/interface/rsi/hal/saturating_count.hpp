// Saturating count: a counter that stays at its largest value instead of starting again at zero.
#pragma once

#include <cstdint>
#include <limits>

namespace rsi::hal {

constexpr void count_up(std::uint32_t& counter, std::uint32_t by = 1U) noexcept {
    const std::uint32_t room = std::numeric_limits<std::uint32_t>::max() - counter;
    counter += by < room ? by : room;
}

}  // namespace rsi::hal
