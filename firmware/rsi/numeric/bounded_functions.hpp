// Sine, cosine, tangent and exponential on the bounded arguments that occur here, with the same bits on every
// target.
//
// The C library's functions differ in the last bit from one platform to the next; these use only +, * and /,
// which IEEE 754 fixes. Series are cut where the first term left out is below one float rounding.
#pragma once

#include "rsi/numeric/bounded.hpp"

namespace rsi {

// Arguments of sine and cosine are clamped to this, of tangent to `largest_tangent_argument_rad`.
inline constexpr float largest_angle_rad = 1.5707963F;
inline constexpr float largest_tangent_argument_rad = 1.3F;

// Error below 2e-7.
constexpr float bounded_sine(float angle_rad) {
    const float x = clamp_magnitude(angle_rad, largest_angle_rad);
    const float z = x * x;
    const float series =
        z * (-1.0F / 6.0F +
             z * (1.0F / 120.0F + z * (-1.0F / 5040.0F + z * (1.0F / 362880.0F - z * (1.0F / 39916800.0F)))));
    return x + x * series;
}

// Error below 1.5e-7.
constexpr float bounded_cosine(float angle_rad) {
    const float x = clamp_magnitude(angle_rad, largest_angle_rad);
    const float z = x * x;
    const float series =
        z * (-0.5F + z * (1.0F / 24.0F +
                          z * (-1.0F / 720.0F + z * (1.0F / 40320.0F +
                                                     z * (-1.0F / 3628800.0F + z * (1.0F / 479001600.0F))))));
    return 1.0F + series;
}

// Relative error below 1e-6; the cosine of the clamped argument is at least 0.26.
constexpr float bounded_tangent(float angle_rad) {
    const float x = clamp_magnitude(angle_rad, largest_tangent_argument_rad);
    return bounded_sine(x) / bounded_cosine(x);
}

// exp(-x) for 0 <= x <= 16 (clamped), relative error below 1e-5: the series at x/64, squared six times.
constexpr float decaying_exponential(float x) {
    const float y = clamp(x, 0.0F, 16.0F) / 64.0F;
    float result =
        1.0F - y * (1.0F - y * (0.5F - y * (1.0F / 6.0F -
                                            y * (1.0F / 24.0F - y * (1.0F / 120.0F - y * (1.0F / 720.0F))))));
    for (int squaring = 0; squaring < 6; ++squaring) {
        result *= result;
    }
    return result;
}

}  // namespace rsi
