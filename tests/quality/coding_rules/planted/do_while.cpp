// A body before its condition.
// Caught by: cppcoreguidelines-avoid-do-while
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t sum = 0U;
    do {
        sum += 1U;
    } while (sum < value);
    return sum;
}

}  // namespace planted
