// Bits that are lost unseen.
// Caught by: clang -Wimplicit-int-conversion, g++ -Wconversion
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint8_t low_byte(std::uint32_t value) {
    return value >> 8U;
}

}  // namespace planted
