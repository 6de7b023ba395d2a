// An order of operators that must be known by heart.
// Caught by: clang -Wparentheses, g++ -Wparentheses, readability-implicit-bool-conversion
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

bool is_violation(std::uint32_t value) {
    return value & 1U == 1U;
}

}  // namespace planted
