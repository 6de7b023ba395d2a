// System random: the kernel's random numbers.
#pragma once

#include <sys/random.h>

#include <cstddef>
#include <cstdint>

#include "rsi/hal/random_source.hpp"

namespace rsi::hal {

class SystemRandom final : public RandomSource {
 public:
    bool fill(std::uint8_t* bytes, std::size_t length) noexcept override {
        const ssize_t filled = ::getrandom(bytes, length, GRND_NONBLOCK);
        return (filled >= 0) && (static_cast<std::size_t>(filled) == length);
    }
};

}  // namespace rsi::hal
