// Memory from the heap.
// Caught by: clang-analyzer-cplusplus.NewDeleteLeaks, heap
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::uint32_t* const copy = new std::uint32_t{value};
    return *copy;
}

}  // namespace planted
