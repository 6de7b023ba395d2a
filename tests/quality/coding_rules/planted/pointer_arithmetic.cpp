// A pointer that is counted on.
// Caught by: cppcoreguidelines-pro-bounds-pointer-arithmetic
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

const std::uint32_t* pointer_violation(const std::uint32_t* value) {
    return value + 1;
}

}  // namespace planted
