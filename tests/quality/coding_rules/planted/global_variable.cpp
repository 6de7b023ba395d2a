// State outside of any object.
// Caught by: cppcoreguidelines-avoid-non-const-global-variables
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t total = 0U;
std::uint32_t violation(std::uint32_t value) {
    total += value;
    return total;
}

}  // namespace planted
