// The place of a member in memory.
// Caught by: offset
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <cstddef>

namespace planted {

struct Pair {
    std::uint32_t first;
    std::uint32_t second;
};
std::uint32_t violation(std::uint32_t value) {
    return value + static_cast<std::uint32_t>(offsetof(Pair, second));
}

}  // namespace planted
