// One name for two things.
// Caught by: clang -Wshadow, g++ -Wshadow
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t sum = value;
    for (std::uint32_t count = 0U; count < 2U; ++count) {
        const std::uint32_t sum = count;
        use(sum);
    }
    sum += 1U;
    return sum;
}

}  // namespace planted
