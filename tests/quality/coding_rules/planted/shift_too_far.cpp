// A shift by more than the width.
// Caught by: clang -Wshift-count-overflow, clang-analyzer-core.BitwiseShift, g++
// -Wshift-count-overflow
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return value << 32U;
}

}  // namespace planted
