// Times of a campaign's runs, and how they are compared.
#pragma once

namespace sil {

// A warning is early when it comes so long before two-wheel lift-off.
inline constexpr double early_s = 0.1;
// Times are sums of steps of 1 ms, and whole milliseconds in the rows.
inline constexpr double rounding_s = 1.0e-6;

}  // namespace sil
