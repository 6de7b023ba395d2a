// A chain that does not say what else.
// Caught by: else-if-without-else
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t answer = 0U;
    if (value > 7U) {
        answer = 1U;
    } else if (value > 3U) {
        answer = 2U;
    }
    return answer;
}

}  // namespace planted
