// A variable that never changes.
// Caught by: misc-const-correctness
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t copy = value;
    return copy + 1U;
}

}  // namespace planted
