// A volatile object that is no register.
// Caught by: volatile
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const volatile std::uint32_t copy = value;
    return copy;
}

}  // namespace planted
