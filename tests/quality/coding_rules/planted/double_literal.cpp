// Double precision by a literal alone.
// Caught by: double
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

float float_violation(float value) {
    return static_cast<float>(0.5) * value;
}

}  // namespace planted
