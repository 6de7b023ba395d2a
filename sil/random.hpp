// Random: numbers of which every bit is the same on every machine; the standard library's distributions need
// not be. There are two generators, for two uses:
// scrambled() makes a number of its argument alone, so that one quantity of a run can be drawn by itself,
// whatever else is drawn: campaigns, roads, seeds.
// RandomStream gives one number after the other, of a sequence without visible pattern: noise, long drives.
// Recordings and reports depend on the numbers of both, so neither can take the other's place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace sil {

inline constexpr std::uint64_t scrambled_step = 0x9E3779B97F4A7C15U;

// The next number of splitmix64 (Steele, Lea, Flood 2014) after the state `value`: neighbouring inputs give
// unrelated outputs, so it serves as a hash too.
constexpr std::uint64_t scrambled(std::uint64_t value) {
    value += scrambled_step;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31U);
}

// Uniform on [0, 1), a multiple of 2^-53.
constexpr double unit_interval(std::uint64_t bits) {
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

// Uniform on [low, high).
constexpr double between(std::uint64_t bits, double low, double high) {
    return low + (high - low) * unit_interval(bits);
}

class RandomStream {
 public:
    explicit RandomStream(std::uint64_t seed) : generator_{seed} {}

    std::uint64_t bits() { return generator_(); }

    double between(double low, double high) { return sil::between(bits(), low, high); }

    // 0 to count - 1, for small counts.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() >> 11U) % count; }

 private:
    std::mt19937_64 generator_;  // its output is fixed by the C++ standard, [rand.predef]
};

}  // namespace sil
