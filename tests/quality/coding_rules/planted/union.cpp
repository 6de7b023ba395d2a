// Two types in one place.
// Caught by: cppcoreguidelines-pro-type-union-access, union
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    union Word {
        std::uint32_t number;
        float real;
    };
    Word word{value};
    word.number += 1U;
    return word.number;
}

}  // namespace planted
