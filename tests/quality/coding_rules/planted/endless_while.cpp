// A loop without an end.
// Caught by: unbounded-loop
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    while (true) {
        use(value);
    }
}

}  // namespace planted
