// A read before the first write.
// Caught by: clang -Wsometimes-uninitialized, clang-analyzer-core.uninitialized.UndefReturn,
// cppcoreguidelines-init-variables
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t sum;
    if (value > 7U) {
        sum = 1U;
    }
    return sum;
}

}  // namespace planted
