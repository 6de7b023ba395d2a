// A jump.
// Caught by: jump
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    if (value > 7U) {
        goto end;
    }
    use(value);
end:
    return value;
}

}  // namespace planted
