// A macro that nobody uses.
// Caught by: clang -Wunused-macros, g++ -Wunused-macros
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

#define PLANTED_NAME value
std::uint32_t violation(std::uint32_t value) {
    return value;
}

}  // namespace planted
