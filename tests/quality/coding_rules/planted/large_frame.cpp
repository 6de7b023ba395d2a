// More stack than a function may have.
// Caught by: g++ -Wstack-usage=
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <array>

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    std::array<std::uint32_t, 512> copies{};
    copies.fill(value);
    use(copies[value % 512U]);
    use_all(copies.data());
    return copies[0];
}

}  // namespace planted
