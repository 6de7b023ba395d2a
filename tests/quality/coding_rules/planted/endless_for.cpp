// A loop without an end that can be read.
// Caught by: unbounded-loop
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    for (std::uint32_t count = 0U;; ++count) {
        if (count > value) {
            return count;
        }
    }
}

}  // namespace planted
