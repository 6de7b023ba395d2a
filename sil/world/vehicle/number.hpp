// Number: what the vehicle's equations need beside + - * /, for a double here and for Lanes in lanes.hpp. The
// same expression gives the same bits in both.
#pragma once

#include <algorithm>
#include <cmath>

namespace sil::number {

// The equations select instead of branching, because in Lanes one vehicle goes one way and another the other.
inline double choose(bool condition, double if_true, double if_false) {
    return condition ? if_true : if_false;
}
inline bool any(bool condition) {
    return condition;
}
inline bool all(bool condition) {
    return condition;
}

inline double max(double a, double b) {
    return std::max(a, b);
}
inline double min(double a, double b) {
    return std::min(a, b);
}
inline double clamp(double value, double lowest, double highest) {
    return std::clamp(value, lowest, highest);
}
inline double abs(double value) {
    return std::abs(value);
}
inline double sqrt(double value) {
    return std::sqrt(value);
}

inline double sin(double value) {
    return std::sin(value);
}
inline void sin_and_cos(double value, double& sine, double& cosine) {
    sine = std::sin(value);
    cosine = std::cos(value);
}
inline double tan(double value) {
    return std::tan(value);
}
inline double asin(double value) {
    return std::asin(value);
}
inline double atan(double value) {
    return std::atan(value);
}
inline double atan2(double y, double x) {
    return std::atan2(y, x);
}
inline double hypot(double x, double y) {
    return std::hypot(x, y);
}

}  // namespace sil::number
