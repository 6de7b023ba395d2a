// A sign that changes unseen.
// Caught by: bugprone-narrowing-conversions, clang -Wsign-conversion, g++ -Wsign-conversion
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    const std::int32_t copy = value;
    return static_cast<std::uint32_t>(copy);
}

}  // namespace planted
