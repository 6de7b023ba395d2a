// A variable without a first value.
// Caught by: cppcoreguidelines-init-variables
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t sum;
    sum = value;
    return sum;
}

}  // namespace planted
