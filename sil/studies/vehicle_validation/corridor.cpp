#include "sil/studies/vehicle_validation/corridor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sil {

Corridor corridor_about(const std::vector<double>& measured, double step_s, const Tolerance& tolerance) {
    const auto reach = static_cast<std::ptrdiff_t>(std::lround(tolerance.time_s / step_s));
    const auto count = static_cast<std::ptrdiff_t>(measured.size());
    Corridor corridor;
    for (std::ptrdiff_t place = 0; place < count; ++place) {
        const auto [lowest, highest] =
            std::minmax_element(measured.begin() + std::max<std::ptrdiff_t>(0, place - reach),
                                measured.begin() + std::min(count, place + reach + 1));
        corridor.lower.push_back(*lowest - tolerance.offset - tolerance.share * std::fabs(*lowest));
        corridor.upper.push_back(*highest + tolerance.offset + tolerance.share * std::fabs(*highest));
    }
    return corridor;
}

double share_within(const Corridor& corridor, const std::vector<double>& predicted,
                    const std::vector<bool>& counts) {
    double within = 0.0;
    double counted = 0.0;
    for (std::size_t place = 0U; place < predicted.size(); ++place) {
        if (counts[place]) {
            counted += 1.0;
            within += predicted[place] >= corridor.lower[place] && predicted[place] <= corridor.upper[place]
                          ? 1.0
                          : 0.0;
        }
    }
    return counted > 0.0 ? within / counted : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace sil
