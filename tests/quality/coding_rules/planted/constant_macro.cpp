// A constant as a macro.
// Caught by: cppcoreguidelines-macro-usage
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

#define PLANTED_LIMIT 7U
std::uint32_t violation(std::uint32_t value) {
    return (value > PLANTED_LIMIT) ? PLANTED_LIMIT : value;
}

}  // namespace planted
