// Two branches that do the same.
// Caught by: bugprone-branch-clone, g++ -Wduplicated-branches
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t answer = 0U;
    if (value > 7U) {
        answer = 1U;
    } else {
        answer = 1U;
    }
    return answer;
}

}  // namespace planted
