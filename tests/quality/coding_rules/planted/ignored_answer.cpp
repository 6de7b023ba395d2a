// An answer that nobody reads.
// Caught by: clang -Wunused-result, g++ -Wunused-result
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    has_started(value);
    return value;
}

}  // namespace planted
