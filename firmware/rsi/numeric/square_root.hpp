// Square root: correctly rounded by IEEE 754, and therefore the same on every target.
#pragma once

namespace rsi {

// `x` at least 0. One instruction where the target has a floating-point unit and the compiler need not set
// errno (-fno-math-errno), so that no library is called.
inline float square_root(float x) {
    return __builtin_sqrtf(x);
}

}  // namespace rsi
