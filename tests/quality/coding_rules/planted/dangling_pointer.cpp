// A pointer to what is gone.
// Caught by: clang -Wreturn-stack-address, clang-analyzer-core.StackAddressEscape, g++
// -Wreturn-local-addr
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

const std::uint32_t* pointer_violation(const std::uint32_t* value) {
    const std::uint32_t copy = *value;
    return &copy;
}

}  // namespace planted
