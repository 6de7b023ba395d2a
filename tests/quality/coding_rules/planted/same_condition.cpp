// A branch that is never taken.
// Caught by: g++ -Wduplicated-cond
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t answer = 0U;
    if (value > 7U) {
        answer = 1U;
    } else if (value > 7U) {
        answer = 2U;
    } else {
        answer = 3U;
    }
    return answer;
}

}  // namespace planted
