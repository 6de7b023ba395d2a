// Instructions of one processor.
// Caught by: assembly
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    asm("nop");
    return value;
}

}  // namespace planted
