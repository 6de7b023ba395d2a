// A check switched off in the source.
// Caught by: suppression
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::int32_t signed_violation(std::int32_t value) {
    return value << 1;  // NOLINT
}

}  // namespace planted
