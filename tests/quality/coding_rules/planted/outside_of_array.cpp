// An index beyond the end.
// Caught by: g++ -Warray-bounds
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <array>

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    constexpr std::array<std::uint32_t, 2> table{1U, 2U};
    return value + table[2];
}

}  // namespace planted
