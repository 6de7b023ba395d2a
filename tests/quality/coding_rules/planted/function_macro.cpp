// A macro that looks like a function.
// Caught by: cppcoreguidelines-macro-usage, function-macro
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

#define TWICE(x) ((x) + (x))
std::uint32_t violation(std::uint32_t value) {
    return TWICE(value);
}

}  // namespace planted
