// Length of a plane vector from +, * and / only, so that no library is called.
#pragma once

#include "rsi/numeric/bounded.hpp"

namespace rsi {

// sqrt(a^2 + b^2) with a relative error below 3e-7, for any magnitudes whose sum is finite.
constexpr float vector_length(float a, float b) {
    const float longer = larger(absolute(a), absolute(b));
    const float shorter = smaller(absolute(a), absolute(b));
    if (!(longer > 0.0F)) {
        return 0.0F;
    }
    const float ratio = shorter / longer;
    const float square = 1.0F + ratio * ratio;  // 1 to 2
    // The chord plus half its gap is within 1 % of the root; each of Newton's steps squares the error.
    float root = 0.59F + 0.4142136F * square;
    root = 0.5F * (root + square / root);
    root = 0.5F * (root + square / root);
    return longer * root;
}

}  // namespace rsi
