#include "sil/judge/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sil {

ConfidenceInterval wilson_interval(double count, double total) {
    if (!(total > 0.0)) {
        return {};
    }
    constexpr double z = 1.959963984540054;  // of the normal distribution, 2.5 % on either side
    const double p = count / total;
    const double centre = p + z * z / (2.0 * total);
    const double half_width = z * std::sqrt(p * (1.0 - p) / total + z * z / (4.0 * total * total));
    const double scale = 1.0 + z * z / total;
    return {std::max(0.0, (centre - half_width) / scale), std::min(1.0, (centre + half_width) / scale)};
}

double Share::value() const {
    return total == 0U ? std::numeric_limits<double>::quiet_NaN()
                       : static_cast<double>(count) / static_cast<double>(total);
}

ConfidenceInterval Share::confidence() const {
    const double trials = independent > 0.0 ? independent : static_cast<double>(total);
    return total == 0U ? ConfidenceInterval{} : wilson_interval(value() * trials, trials);
}

Share ShareByVehicle::share() const {
    Share all;
    std::size_t with_runs = 0U;
    for (const Share& share : vehicles_) {
        all.count += share.count;
        all.total += share.total;
        with_runs += share.total > 0U ? 1U : 0U;
    }
    if (with_runs < fewest_clusters) {
        return all;
    }
    const auto vehicles = static_cast<double>(with_runs);
    const auto total = static_cast<double>(all.total);
    const double p = all.value();
    double squares = 0.0;
    for (const Share& share : vehicles_) {
        const double residual = static_cast<double>(share.count) - p * static_cast<double>(share.total);
        squares += residual * residual;
    }
    const double variance = vehicles / (vehicles - 1.0) * squares / (total * total);
    // Never below 1.8: the variance is largest where some vehicles always count and the others never.
    all.independent =
        all.count == 0U || all.count == all.total
            ? vehicles
            : std::min(p * (1.0 - p) / std::max(variance, std::numeric_limits<double>::min()), total);
    return all;
}

std::optional<double> quantile(std::vector<double> values, double share) {
    if (values.empty()) {
        return std::nullopt;
    }
    const double place = share * static_cast<double>(values.size() - 1U);
    const auto below = values.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(values.begin(), below, values.end());
    const auto above = below + 1 == values.end() ? below : std::min_element(below + 1, values.end());
    return *below + (place - std::floor(place)) * (*above - *below);
}

}  // namespace sil
