// Double precision, by type and by literal.
// Caught by: double
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

float float_violation(float value) {
    const double half = 0.5;
    return static_cast<float>(half) * value;
}

}  // namespace planted
