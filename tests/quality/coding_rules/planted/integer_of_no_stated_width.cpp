// An integer whose width depends on the target.
// Caught by: integer-type
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const unsigned long copy{value};
    return static_cast<std::uint32_t>(copy);
}

}  // namespace planted
