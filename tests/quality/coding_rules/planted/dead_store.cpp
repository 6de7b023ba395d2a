// A value that nobody reads.
// Caught by: clang-analyzer-deadcode.DeadStores
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t sum = value;
    use(sum);
    sum = 2U;
    return value;
}

}  // namespace planted
