// Square root from +, * and / only, so that no library is called.
#pragma once

#include <cstdint>
#include <cstring>

#include "rsi/numeric/bounded.hpp"

namespace rsi {

// For 0 and 1e-37 to 1e38: relative error below 3e-7. Anything smaller gives 0.
inline float square_root(float value) {
    if (!(value >= 1.0e-37F)) {
        return 0.0F;
    }
    // Halving the exponent gives the root within 4 %; each of Newton's steps squares the error.
    std::uint32_t bits = 0U;
    std::memcpy(&bits, &value, sizeof(bits));
    bits = 0x1FBD1DF5U + (bits >> 1U);
    float root = 0.0F;
    std::memcpy(&root, &bits, sizeof(root));
    for (int step = 0; step < 3; ++step) {
        root = 0.5F * (root + value / root);
    }
    return root;
}

}  // namespace rsi
