// A header that is not on the list.
// Caught by: header
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <string>

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return value;
}

}  // namespace planted
