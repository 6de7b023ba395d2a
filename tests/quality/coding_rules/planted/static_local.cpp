// State that nobody owns.
// Caught by: static-local
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    static std::uint32_t sum = 0U;
    sum += value;
    return sum;
}

}  // namespace planted
