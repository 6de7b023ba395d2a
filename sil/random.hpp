// Random: numbers of which every bit is the same on every machine; the standard library's distributions need
// not be.
#pragma once

#include <cstdint>

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

}  // namespace sil
