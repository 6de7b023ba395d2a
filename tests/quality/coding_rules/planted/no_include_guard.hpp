// A header that may be read twice.
// Caught by: include-guard
#include <cstdint>

namespace planted {

constexpr std::uint32_t twice(std::uint32_t value) {
    return 2U * value;
}

}  // namespace planted
