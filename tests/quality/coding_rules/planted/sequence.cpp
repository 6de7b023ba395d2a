// Two changes without an order.
// Caught by: clang -Wunsequenced, g++ -Wsequence-point
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::int32_t signed_violation(std::int32_t value) {
    std::int32_t count = value;
    return count++ + count++;
}

}  // namespace planted
