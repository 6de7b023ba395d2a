// A time that the caller did not give.
// Caught by: environment, header
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <ctime>

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    return value + static_cast<std::uint32_t>(std::time(nullptr));
}

}  // namespace planted
