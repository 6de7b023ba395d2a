// A pointer that is only read through.
// Caught by: readability-non-const-parameter
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t read(std::uint32_t* value) {
    return *value;
}

}  // namespace planted
