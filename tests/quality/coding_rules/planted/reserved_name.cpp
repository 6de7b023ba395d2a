// A name that belongs to the compiler.
// Caught by: bugprone-reserved-identifier, clang -Wreserved-identifier
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::uint32_t __copy = value;
    return __copy;
}

}  // namespace planted
