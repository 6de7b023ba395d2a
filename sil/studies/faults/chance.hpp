// Chance: uniform numbers that are the same on every machine; the library's own distributions need not be.
#pragma once

#include <cstdint>
#include <random>

namespace sil {

class Chance {
 public:
    explicit Chance(std::uint64_t seed) : generator_{seed} {}

    double between(double low, double high) {
        constexpr double unit = 1.0 / 9007199254740992.0;  // 2^-53
        return low + (high - low) * unit * static_cast<double>(generator_() >> 11U);
    }

    // 0 to count - 1, for small counts.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(generator_() >> 11U) % count; }

 private:
    std::mt19937_64 generator_;
};

}  // namespace sil
