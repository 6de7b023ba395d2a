// An array passed as a pointer.
// Caught by: cppcoreguidelines-pro-bounds-array-to-pointer-decay
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::uint32_t* const first = shared_table;
    return *first + value;
}

}  // namespace planted
