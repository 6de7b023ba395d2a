// An object made in place.
// Caught by: placement-new
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <array>
#include <new>

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    alignas(4) std::array<std::uint8_t, 4> storage{};
    return *::new (static_cast<void*>(storage.data())) std::uint32_t{value};
}

}  // namespace planted
