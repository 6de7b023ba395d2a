// A header of C.
// Caught by: modernize-deprecated-headers
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <stdint.h>

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return value;
}

}  // namespace planted
