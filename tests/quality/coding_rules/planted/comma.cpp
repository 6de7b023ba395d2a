// Two statements by a comma.
// Caught by: clang -Wcomma
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t sum = 0U;
    sum += 1U, sum += value;
    return sum;
}

}  // namespace planted
