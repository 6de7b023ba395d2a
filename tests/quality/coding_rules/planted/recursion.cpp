// A function that calls itself.
// Caught by: misc-no-recursion
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return (value == 0U) ? 0U : violation(value / 2U) + 1U;
}

}  // namespace planted
