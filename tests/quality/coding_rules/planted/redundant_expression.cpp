// A difference of the same.
// Caught by: misc-redundant-expression
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return value - value;
}

}  // namespace planted
