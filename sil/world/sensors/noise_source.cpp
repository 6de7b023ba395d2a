// NoiseSource: seeding by splitmix64 and the sum of uniform integers.
#include "sil/world/sensors/noise_source.hpp"

namespace sil {
namespace {

// The finaliser of splitmix64 (Steele, Lea, Flood 2014): neighbouring inputs give unrelated outputs.
std::uint64_t scramble(std::uint64_t value) {
    value += 0x9E3779B97F4A7C15U;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31U);
}

}  // namespace

NoiseSource::NoiseSource(std::uint64_t seed, std::uint64_t stream)
    : generator_(scramble(scramble(seed) ^ stream)) {}

double NoiseSource::next() {
    constexpr int draws = 6;  // each gives two uniform values of 32 bits
    constexpr std::int64_t mean = std::int64_t{draws} * 0xFFFFFFFF;  // of all twelve together
    std::int64_t sum = 0;
    for (int draw = 0; draw < draws; ++draw) {
        const std::uint64_t bits = generator_();
        sum += static_cast<std::int64_t>(bits >> 32U) + static_cast<std::int64_t>(bits & 0xFFFFFFFFU);
    }
    return static_cast<double>(sum - mean) * 0x1p-32;
}

}  // namespace sil
