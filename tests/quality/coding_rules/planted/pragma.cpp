// A warning switched off by a pragma.
// Caught by: pragma
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

#pragma GCC diagnostic ignored "-Wunused-variable"
std::uint32_t violation(std::uint32_t value) {
    return value;
}

}  // namespace planted
