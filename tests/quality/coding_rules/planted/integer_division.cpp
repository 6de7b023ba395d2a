// A quotient of integers that was meant to be real.
// Caught by: bugprone-integer-division
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

float float_violation(float value) {
    const std::int32_t a = 1;
    const std::int32_t b = 2;
    return value * static_cast<float>(a / b) + static_cast<float>(b);
}

}  // namespace planted
