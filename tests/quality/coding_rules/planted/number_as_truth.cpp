// A number where a truth was asked for.
// Caught by: readability-implicit-bool-conversion
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

bool is_violation(std::uint32_t value) {
    return value;
}

}  // namespace planted
