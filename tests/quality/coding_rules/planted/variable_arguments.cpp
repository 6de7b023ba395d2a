// Arguments without a type.
// Caught by: cert-dcl50-cpp, cppcoreguidelines-pro-bounds-array-to-pointer-decay, header,
// variable-arguments
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <cstdarg>

namespace planted {

std::uint32_t sum(std::uint32_t count, ...) {
    va_list arguments;
    va_start(arguments, count);
    va_end(arguments);
    return count;
}

}  // namespace planted
