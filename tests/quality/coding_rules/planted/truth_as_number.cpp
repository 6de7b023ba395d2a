// A truth where a number was asked for.
// Caught by: readability-implicit-bool-conversion
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const bool large = value > 7U;
    return value + large;
}

}  // namespace planted
