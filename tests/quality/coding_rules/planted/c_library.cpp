// A function of the C library.
// Caught by: c-library
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <cstring>

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const char* const text = "text";
    return value + static_cast<std::uint32_t>(strlen(text));
}

}  // namespace planted
