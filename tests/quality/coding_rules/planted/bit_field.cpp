// Bits of no stated place.
// Caught by: bit-field
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    struct Flags {
        std::uint32_t low : 4;
        std::uint32_t high : 28;
    };
    const Flags flags{value & 0xFU, 0U};
    const std::uint32_t low = flags.low;
    return low;
}

}  // namespace planted
