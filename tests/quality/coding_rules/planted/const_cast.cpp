// A write to what was promised to stay.
// Caught by: const-cast
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

void clear(const std::uint32_t& value) {
    const_cast<std::uint32_t&>(value) = 0U;
}

}  // namespace planted
