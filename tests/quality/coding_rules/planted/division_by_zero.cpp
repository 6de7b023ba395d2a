// A division by zero.
// Caught by: clang-analyzer-core.DivideZero
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::uint32_t divisor = (value > 7U) ? 0U : value;
    if (value > 7U) {
        return value / divisor;
    }
    return divisor;
}

}  // namespace planted
