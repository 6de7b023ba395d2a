#include "sil/studies/identification/drive_signals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sil/studies/identification/zero_phase_filter.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

bool usable(const DriveCycle& cycle) {
    return cycle.has_frames && std::isfinite(cycle.sample.lateral_acceleration_mps2) &&
           std::isfinite(cycle.sample.roll_rate_radps) && std::isfinite(cycle.sample.roll_angle_rad);
}

}  // namespace

bool complete(const Signal& signal) {
    return std::all_of(signal.begin(), signal.end(), [](double value) { return std::isfinite(value); });
}

bool has_loads(const DriveSample& sample) {
    return std::all_of(sample.wheel_load_n.begin(), sample.wheel_load_n.end(),
                       [](double value) { return std::isfinite(value); });
}

double load_moment_nm(const DriveSample& sample, double track_width_m) {
    const auto& load = sample.wheel_load_n;
    return 0.5 * track_width_m * (load[front_right] + load[rear_right] - load[front_left] - load[rear_left]);
}

Cycles longest_whole_part(const Cycles& cycles) {
    std::size_t best_begin = 0U, best_length = 0U, begin = 0U;
    for (std::size_t k = 0U; k <= cycles.size(); ++k) {
        if (k < cycles.size() && usable(cycles[k])) {
            continue;
        }
        if (k - begin > best_length) {
            best_begin = begin;
            best_length = k - begin;
        }
        begin = k + 1U;
    }
    const auto first = cycles.begin() + static_cast<std::ptrdiff_t>(best_begin);
    return {first, first + static_cast<std::ptrdiff_t>(best_length)};
}

Signal smooth(const Cycles& cycles, double DriveSample::* member, double lag_s) {
    Signal signal;
    for (const DriveCycle& cycle : cycles) {
        signal.push_back(cycle.sample.*member);
    }
    return complete(signal) ? filter_without_delay(std::move(signal), lag_s, sample_time_s)
                            : Signal(cycles.size(), std::numeric_limits<double>::quiet_NaN());
}

std::array<double, 2> road_forces(double lateral, double vertical, double roll) {
    const double sine = std::sin(roll), cosine = std::cos(roll);
    if (!std::isfinite(vertical)) {  // as the firmware does: no heave, a level road
        return {(lateral - g_mps2 * sine) / cosine, g_mps2};
    }
    return {lateral * cosine - vertical * sine, lateral * sine + vertical * cosine};
}

}  // namespace sil
