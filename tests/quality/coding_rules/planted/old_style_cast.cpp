// A cast that does not say what it does.
// Caught by: clang -Wold-style-cast, g++ -Wold-style-cast
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

float float_violation(float value) {
    return value + (float)1U;
}

}  // namespace planted
