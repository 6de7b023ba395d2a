// NoiseSource: seeding by splitmix64 and the sum of uniform integers.
#include "sil/world/sensors/noise_source.hpp"

namespace sil {
NoiseSource::NoiseSource(std::uint64_t seed, std::uint64_t stream)
    : generator_(scrambled(scrambled(seed) ^ stream)) {}

double NoiseSource::next() {
    constexpr int draws = 6;  // each gives two uniform values of 32 bits
    constexpr std::int64_t mean = std::int64_t{draws} * 0xFFFFFFFF;  // of all twelve together
    std::int64_t sum = 0;
    for (int draw = 0; draw < draws; ++draw) {
        const std::uint64_t bits = generator_.bits();
        sum += static_cast<std::int64_t>(bits >> 32U) + static_cast<std::int64_t>(bits & 0xFFFFFFFFU);
    }
    return static_cast<double>(sum - mean) * 0x1p-32;
}

}  // namespace sil
