// A fraction that is lost unseen.
// Caught by: bugprone-narrowing-conversions, clang -Wfloat-conversion, clang
// -Wimplicit-int-float-conversion, g++ -Wconversion, g++ -Wfloat-conversion
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::int32_t signed_violation(std::int32_t value) {
    const float half = 0.5F;
    return value + half;
}

}  // namespace planted
