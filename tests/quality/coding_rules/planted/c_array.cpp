// An array that does not know its size.
// Caught by: cppcoreguidelines-avoid-c-arrays
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::uint32_t table[2] = {1U, value};
    return table[1];
}

}  // namespace planted
