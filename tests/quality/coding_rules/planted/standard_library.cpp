// A type that takes memory from the heap.
// Caught by: header, standard-library
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <vector>

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::vector<std::uint32_t> copy(1U, value);
    return copy.front();
}

}  // namespace planted
