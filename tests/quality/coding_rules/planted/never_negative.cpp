// A question whose answer is known.
// Caught by: clang -Wtautological-unsigned-zero-compare, g++ -Wtype-limits
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

bool is_violation(std::uint32_t value) {
    return value >= 0U;
}

}  // namespace planted
