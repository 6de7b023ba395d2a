// Guards on numbers: finite, within a range, never divided by too little.
#pragma once

#include <limits>

#include "rsi/float_rules.h"

namespace rsi {

constexpr float not_available = std::numeric_limits<float>::quiet_NaN();

// False for NaN and for anything outside [minimum, maximum].
constexpr bool is_within(float value, float minimum, float maximum) {
    return (value >= minimum) && (value <= maximum);
}

// One instruction on every target with a floating-point unit.
constexpr float absolute(float value) {
    return __builtin_fabsf(value);
}

// False for NaN and for anything outside [-limit, limit].
constexpr bool is_within_magnitude(float value, float limit) {
    return absolute(value) <= limit;
}

// A finite value less itself is zero, any other is NaN: needs no constant to compare with.
constexpr bool is_finite(float value) {
    return (value - value) >= 0.0F;
}

// Bounds a finite value.
constexpr float clamp(float value, float minimum, float maximum) {
    return (value < minimum) ? minimum : ((value > maximum) ? maximum : value);
}

// Bounds a finite value to [-limit, limit]; cheaper than clamp(), because nearly every value needs one
// comparison.
constexpr float clamp_magnitude(float value, float limit) {
    return (absolute(value) > limit) ? ((value < 0.0F) ? -limit : limit) : value;
}

constexpr float smaller(float a, float b) {
    return (a < b) ? a : b;
}

constexpr float larger(float a, float b) {
    return (a > b) ? a : b;
}

}  // namespace rsi
