// A function that cannot be followed.
// Caught by: readability-function-cognitive-complexity
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t answer = 0U;
    if (value > 0U) {
        for (std::uint32_t k = 0U; k < value; ++k) {
            if (k > 3U) {
                answer += k;
            }
        }
    }
    if (value > 1U) {
        for (std::uint32_t k = 0U; k < value; ++k) {
            if (k > 4U) {
                answer += k;
            }
        }
    }
    if (value > 2U) {
        for (std::uint32_t k = 0U; k < value; ++k) {
            if (k > 5U) {
                answer += k;
            }
        }
    }
    if (value > 3U) {
        for (std::uint32_t k = 0U; k < value; ++k) {
            if (k > 6U) {
                answer += k;
            }
        }
    }
    if (value > 4U) {
        for (std::uint32_t k = 0U; k < value; ++k) {
            if (k > 7U) {
                answer += k;
            }
        }
    }
    return answer;
}

}  // namespace planted
