// A stack that grows with the input.
// Caught by: clang -Wvla-cxx-extension, cppcoreguidelines-avoid-c-arrays, g++ -Wvla
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::uint32_t copies[value];
    copies[0] = value;
    return copies[0];
}

}  // namespace planted
