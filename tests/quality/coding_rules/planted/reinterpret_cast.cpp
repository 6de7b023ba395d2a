// A float read as an integer.
// Caught by: clang -Wundefined-reinterpret-cast, reinterpret-cast
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t bits_of(const float& value) {
    return *reinterpret_cast<const std::uint32_t*>(&value);
}

}  // namespace planted
