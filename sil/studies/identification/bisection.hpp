// Bisection: where a condition ends.
#pragma once

namespace sil {

// The last angle, length or the like within [low, high] at which `holds(x)`, for a condition that ends once.
template <typename Condition>
double last_where(const Condition& holds, double low, double high) {
    for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace sil
