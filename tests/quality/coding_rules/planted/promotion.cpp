// Float that becomes double unseen.
// Caught by: clang -Wdouble-promotion, g++ -Wdouble-promotion
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

bool is_small(float value) {
    return __builtin_fabs(value) < 1.0F;
}

}  // namespace planted
