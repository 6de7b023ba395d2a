// A cast that does nothing.
// Caught by: g++ -Wuseless-cast, readability-redundant-casting
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return static_cast<std::uint32_t>(value);
}

}  // namespace planted
