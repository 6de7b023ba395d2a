// A macro that is 0 because nobody defined it.
// Caught by: clang -Wundef, g++ -Wundef
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

#if PLANTED_CHOICE
#endif
std::uint32_t violation(std::uint32_t value) {
    return value;
}

}  // namespace planted
