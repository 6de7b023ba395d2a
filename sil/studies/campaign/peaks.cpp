#include "sil/studies/campaign/peaks.hpp"

#include <algorithm>
#include <cmath>

#include "sil/studies/campaign/times.hpp"

namespace sil {
namespace {

// The level that all of the last `cycles` reached; 0 when one of them had none.
double lasting_level(const std::vector<double>& levels, std::size_t last, std::size_t cycles) {
    double level = levels[last];
    for (std::size_t back = 0U; back < cycles; ++back) {
        const double other = levels[last - back];
        if (!std::isfinite(other)) {
            return 0.0;
        }
        level = std::min(level, other);
    }
    return level;
}

}  // namespace

IndexPeaks peaks_of(const std::vector<double>& times_s, const std::vector<double>& levels, std::size_t cycles,
                    const std::optional<double>& lift_time_s) {
    const std::size_t wanted = std::max<std::size_t>(1U, cycles);
    IndexPeaks peaks;
    for (std::size_t k = wanted - 1U; k < levels.size(); ++k) {
        if (lift_time_s && times_s[k] > *lift_time_s + rounding_s) {
            break;
        }
        const double level = lasting_level(levels, k, wanted);
        peaks.whole = std::max(peaks.whole, level);
        if (!lift_time_s || times_s[k] <= *lift_time_s - early_s + rounding_s) {
            peaks.before_100ms = std::max(peaks.before_100ms, level);
        }
        if (level >= 1.0 && !peaks.first_time_s) {
            peaks.first_time_s = times_s[k];
        }
    }
    return peaks;
}

}  // namespace sil
