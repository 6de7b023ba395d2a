// A switch over numbers that does not say what else.
// Caught by: bugprone-switch-missing-default-case, hicpp-multiway-paths-covered
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t answer = 0U;
    switch (value) {
        case 0U:
            answer = 1U;
            break;
        case 1U:
            answer = 2U;
            break;
    }
    return answer;
}

}  // namespace planted
