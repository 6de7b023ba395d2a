// An object for each thread.
// Caught by: thread
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

thread_local constexpr std::uint32_t offset = 1U;
std::uint32_t violation(std::uint32_t value) {
    return value + offset;
}

}  // namespace planted
