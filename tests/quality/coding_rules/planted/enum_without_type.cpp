// An enumeration of no stated size.
// Caught by: enum-type
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    enum class Side { left, right };
    return (value > 7U) ? static_cast<std::uint32_t>(Side::left) : static_cast<std::uint32_t>(Side::right);
}

}  // namespace planted
