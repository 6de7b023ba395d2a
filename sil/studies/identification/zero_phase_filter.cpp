#include "sil/studies/identification/zero_phase_filter.hpp"

#include <algorithm>
#include <cmath>

namespace sil {
namespace {

void lag_twice(std::vector<double>& signal, double gain) {
    for (int pass = 0; pass < 2; ++pass) {
        double state = signal.empty() ? 0.0 : signal.front();
        for (double& value : signal) {
            state += gain * (value - state);
            value = state;
        }
    }
}

}  // namespace

std::vector<double> filter_without_delay(std::vector<double> signal, double lag_s, double step_s) {
    if (lag_s <= 0.0) {
        return signal;
    }
    const double gain = 1.0 - std::exp(-step_s / lag_s);
    lag_twice(signal, gain);
    std::reverse(signal.begin(), signal.end());
    lag_twice(signal, gain);
    std::reverse(signal.begin(), signal.end());
    return signal;
}

std::vector<double> differentiate(const std::vector<double>& signal, double step_s) {
    const std::size_t count = signal.size();
    std::vector<double> slope(count, 0.0);
    for (std::size_t k = 0U; k < count && count > 1U; ++k) {
        const std::size_t before = k > 0U ? k - 1U : k;
        const std::size_t after = k + 1U < count ? k + 1U : k;
        slope[k] = (signal[after] - signal[before]) / (static_cast<double>(after - before) * step_s);
    }
    return slope;
}

}  // namespace sil
