// Exact comparison of floats.
// Caught by: clang -Wfloat-equal, g++ -Wfloat-equal
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

bool is_level(float value) {
    return value == 0.3F;
}

}  // namespace planted
