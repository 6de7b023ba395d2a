// Bits of a number with a sign.
// Caught by: hicpp-signed-bitwise
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::int32_t signed_violation(std::int32_t value) {
    return value & 3;
}

}  // namespace planted
