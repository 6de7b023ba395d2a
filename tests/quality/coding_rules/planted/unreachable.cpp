// A statement that is never reached.
// Caught by: clang -Wunreachable-code
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return value;
    use(value);
}

}  // namespace planted
