// A suffix that looks like a digit.
// Caught by: readability-uppercase-literal-suffix
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return value + 1u;
}

}  // namespace planted
