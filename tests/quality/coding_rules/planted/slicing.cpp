// An object cut down to its base.
// Caught by: cppcoreguidelines-slicing
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    struct Base {
        std::uint32_t first{0U};
    };
    struct Derived : Base {
        std::uint32_t second{0U};
    };
    Derived derived;
    derived.second = value;
    const Base base = derived;
    return base.first;
}

}  // namespace planted
