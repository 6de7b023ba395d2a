// Chance: uniform numbers that are the same on every machine; the library's own distributions need not be.
#pragma once

#include <cstdint>
#include <random>

#include "sil/random.hpp"

namespace sil {

class Chance {
 public:
    explicit Chance(std::uint64_t seed) : generator_{seed} {}

    double between(double low, double high) { return low + (high - low) * unit_interval(generator_()); }

    // 0 to count - 1, for small counts.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(generator_() >> 11U) % count; }

 private:
    std::mt19937_64 generator_;
};

}  // namespace sil
