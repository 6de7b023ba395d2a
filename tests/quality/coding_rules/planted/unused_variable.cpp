// A variable that nobody uses.
// Caught by: clang -Wunused-variable, g++ -Wunused-variable
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::uint32_t copy = value;
    return 1U + value;
}

}  // namespace planted
