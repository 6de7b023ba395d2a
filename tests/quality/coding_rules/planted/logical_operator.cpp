// The same question twice.
// Caught by: g++ -Wlogical-op, misc-redundant-expression
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

bool is_violation(std::uint32_t value) {
    return (value > 7U) && (value > 7U);
}

}  // namespace planted
