// A loop counted in floats.
// Caught by: cert-flp30-c, clang-analyzer-security.FloatLoopCounter
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

float float_violation(float value) {
    float sum = 0.0F;
    for (float x = 0.0F; x < 1.0F; x += 0.1F) {
        sum += x * value;
    }
    return sum;
}

}  // namespace planted
