// External linkage that no header declares.
// Caught by: clang -Wmissing-prototypes, g++ -Wmissing-declarations, misc-use-internal-linkage
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t unknown(std::uint32_t value) {
    return value;
}

}  // namespace planted
