// A constant that does not fit.
// Caught by: clang -Winteger-overflow, g++ -Woverflow
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::int32_t signed_violation(std::int32_t value) {
    return value + (2147483647 + 1);
}

}  // namespace planted
