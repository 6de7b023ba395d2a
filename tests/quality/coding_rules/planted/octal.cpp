// Ten that is eight.
// Caught by: octal
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return value + 010U;
}

}  // namespace planted
