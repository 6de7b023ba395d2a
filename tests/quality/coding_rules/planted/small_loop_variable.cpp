// A loop whose counter is too small.
// Caught by: bugprone-too-small-loop-variable
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t sum = 0U;
    for (std::uint8_t count = 0U; count < value; ++count) {
        sum += 1U;
    }
    return sum;
}

}  // namespace planted
