#include "sil/studies/drives/felt_load_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sil/units.hpp"

namespace sil {
namespace {

constexpr std::size_t mean_over = 10U;  // cycles

// Mean lateral over mean vertical acceleration, from cycle `first` on; a vertical one that is missing counts
// as g.
double mean_ratio(const std::vector<ReplayCycle>& cycles, std::size_t first) {
    double lateral = 0.0, vertical = 0.0;
    for (std::size_t place = first; place < first + mean_over; ++place) {
        const DriveSample& sample = cycles[place].sample;
        lateral += sample.lateral_acceleration_mps2;
        vertical +=
            std::isnan(sample.vertical_acceleration_mps2) ? g_mps2 : sample.vertical_acceleration_mps2;
    }
    return lateral / std::max(vertical, 0.0);
}

}  // namespace

double height_share(const rsi::Parameters& parameters) {
    const auto sprung_kg = static_cast<double>(parameters.sprung_mass_kg);
    const auto unsprung_kg = static_cast<double>(parameters.unsprung_mass_kg);
    const double height_moment_kgm = sprung_kg * static_cast<double>(parameters.sprung_cg_height_m) +
                                     unsprung_kg * static_cast<double>(parameters.unsprung_cg_height_m);
    return 2.0 * height_moment_kgm /
           ((sprung_kg + unsprung_kg) * static_cast<double>(parameters.track_width_m));
}

double felt_load_transfer(const std::vector<ReplayCycle>& cycles, double height_share,
                          const NamedWarning& warning) {
    double largest = EcuOutput::not_available;
    const auto begin = std::lower_bound(
        cycles.begin(), cycles.end(), warning.begin_s - felt_about_s,
        [](const ReplayCycle& cycle, double time_s) { return cycle.sample.time_s < time_s; });
    for (auto first = static_cast<std::size_t>(begin - cycles.begin());
         first + mean_over <= cycles.size() && cycles[first].sample.time_s <= warning.end_s + felt_about_s;
         ++first) {
        // std::fmax takes the number beside a NaN.
        largest = std::fmax(largest, height_share * std::fabs(mean_ratio(cycles, first)));
    }
    return largest;
}

}  // namespace sil
