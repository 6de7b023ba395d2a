// Enumerators without a scope.
// Caught by: unscoped-enum
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    enum Side : std::uint8_t { left, right };
    const Side side = (value > 7U) ? left : right;
    return (side == left) ? 1U : 2U;
}

}  // namespace planted
