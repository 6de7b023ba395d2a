// Sine, versine, tangent and exponential on the bounded arguments that occur here, with the same bits on
// every target.
//
// The C library's functions differ in the last bit from one platform to the next; these use only +, * and /,
// which IEEE 754 fixes. Polynomials end where their error is about one float rounding.
#pragma once

#include "rsi/numeric/bounded.hpp"

namespace rsi {

// Arguments of sine, versine and tangent are clamped to this.
inline constexpr float largest_angle_rad = 1.3F;

// Sine and versine 1 - cos of one angle share its square.
struct SineAndVersine {
    float sine;
    float versine;
};

// For an angle that is within `largest_angle_rad`. Errors below 3e-7 of the sine, and below 8e-6 of itself of
// the versine: polynomials of least largest error.
constexpr SineAndVersine sine_and_versine(float x) {
    const float z = x * x;
    const float sine_series = z * (-0.166663453F + z * (0.00832335930F + z * -1.89076978e-4F));
    const float versine = z * (0.499996394F + z * (-0.0416280478F + z * 0.00132742315F));
    return SineAndVersine{x + x * sine_series, versine};
}

constexpr SineAndVersine bounded_sine_and_versine(float angle_rad) {
    return sine_and_versine(clamp_magnitude(angle_rad, largest_angle_rad));
}

// Relative error below 5e-5; the cosine of the clamped argument is at least 0.26.
constexpr float bounded_tangent(float angle_rad) {
    const SineAndVersine of = bounded_sine_and_versine(angle_rad);
    return of.sine / (1.0F - of.versine);
}

// tan x for |x| <= 0.5, relative error below 2e-6.
constexpr float short_range_tangent(float x) {
    const float z = x * x;
    return x + x * (z * (0.333412439F + z * (0.131470561F + z * 0.0661727712F)));
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
