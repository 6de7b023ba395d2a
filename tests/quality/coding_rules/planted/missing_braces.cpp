// A branch without braces.
// Caught by: readability-braces-around-statements, readability-misleading-indentation
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

// clang-format off
std::uint32_t violation(std::uint32_t value) {
if (value > 7U)
return 1U;
return value;
}
// clang-format on

}  // namespace planted
