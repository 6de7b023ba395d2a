#include "sil/studies/campaign/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sil {

ConfidenceInterval wilson_interval(std::size_t count, std::size_t total) {
    if (total == 0U) {
        return {};
    }
    constexpr double z = 1.959963984540054;  // of the normal distribution, 2.5 % on either side
    const auto n = static_cast<double>(total);
    const double p = static_cast<double>(count) / n;
    const double centre = p + z * z / (2.0 * n);
    const double half_width = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    const double scale = 1.0 + z * z / n;
    return {std::max(0.0, (centre - half_width) / scale), std::min(1.0, (centre + half_width) / scale)};
}

double Share::value() const {
    return total == 0U ? std::numeric_limits<double>::quiet_NaN()
                       : static_cast<double>(count) / static_cast<double>(total);
}

std::optional<double> quantile(std::vector<double> values, double share) {
    if (values.empty()) {
        return std::nullopt;
    }
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1U);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1U, values.size() - 1U);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace sil
