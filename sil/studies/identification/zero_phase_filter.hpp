// Zero-phase filter: smooths recorded signals without shifting them in time.
#pragma once

#include <vector>

namespace sil {

// Two first-order lags of `lag_s` forwards and two backwards: the gain is 1 / (1 + (w lag)^2)^2, the phase
// zero. It starts and ends as if the first and the last value had stood for ever.
std::vector<double> filter_without_delay(std::vector<double> signal, double lag_s, double step_s);

// Central differences; at both ends one-sided.
std::vector<double> differentiate(const std::vector<double>& signal, double step_s);

}  // namespace sil
