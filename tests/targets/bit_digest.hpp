// Digest of the bits of many numbers (FNV-1a, 64 bits), the same whatever the order of bytes in memory.
#pragma once

#include <cstdint>
#include <cstring>

namespace target {

class BitDigest {
 public:
    // All that are not numbers count as one: which bits they have is left to the processor.
    void add(float value) {
        std::uint32_t bits = not_a_number;
        if (value == value) {
            std::memcpy(&bits, &value, sizeof(bits));
        }
        add(bits);
    }

    void add(std::uint32_t word) {
        for (unsigned shift = 0U; shift < 32U; shift += 8U) {
            digest_ = (digest_ ^ ((word >> shift) & 0xFFU)) * prime;
        }
    }

    std::uint64_t value() const { return digest_; }

 private:
    static constexpr std::uint32_t not_a_number = 0x7FC0'0000U;
    static constexpr std::uint64_t prime = 0x0000'0100'0000'01B3U;
    std::uint64_t digest_{0xCBF2'9CE4'8422'2325U};
};

}  // namespace target
