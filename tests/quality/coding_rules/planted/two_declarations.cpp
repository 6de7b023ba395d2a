// Two variables in one declaration.
// Caught by: readability-isolate-declaration
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::uint32_t one = value, two = value + one;
    return two;
}

}  // namespace planted
