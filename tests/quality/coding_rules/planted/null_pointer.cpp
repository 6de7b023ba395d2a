// Reading from nowhere.
// Caught by: clang-analyzer-core.NullDereference, g++ -Wnull-dereference
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

const std::uint32_t* pointer_violation(const std::uint32_t* value) {
    if (value == nullptr) {
        use(*value);
    }
    return value;
}

}  // namespace planted
