// Zero as a null pointer.
// Caught by: clang -Wzero-as-null-pointer-constant, g++ -Wzero-as-null-pointer-constant
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

const std::uint32_t* pointer_violation(const std::uint32_t* value) {
    use(*value);
    return 0;
}

}  // namespace planted
