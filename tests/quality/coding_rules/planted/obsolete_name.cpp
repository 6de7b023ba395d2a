// A null pointer by a macro.
// Caught by: obsolete
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <cstddef>

namespace planted {

bool is_null(const std::uint32_t* value) {
    return value == NULL;
}

}  // namespace planted
