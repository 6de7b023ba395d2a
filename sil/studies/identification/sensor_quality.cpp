#include "sil/studies/identification/sensor_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sil/studies/drives/resample.hpp"

namespace sil {
namespace {

// A filtered accelerometer stays below it on a rough road.
constexpr double quiet_mps2 = 0.3;
// As `largest_fine_step_mps` of the monitoring (firmware/rsi/ecu/monitoring/input_monitor.cpp).
constexpr double fine_step_mps = 0.05;
// Digits of a text file.
constexpr double rounding_mps = 1.0e-4;
constexpr std::size_t least_steps = 3U;
// Half of the magnitudes of white noise are below this share of its rms; its second difference has sqrt(6) of
// the rms.
constexpr double median_of_noise = 0.6745;
const double second_difference_of_noise = std::sqrt(6.0);

bool follows(const DriveSample& before, const DriveSample& after) {
    return after.time_s - before.time_s <= longest_bridged_gap_s;
}

// The median, because a kerb or a pothole is no noise.
double noise_rms(const Drive& drive, double DriveSample::* force) {
    std::vector<double> changes;
    for (std::size_t i = 2U; i < drive.samples.size(); ++i) {
        const DriveSample& first = drive.samples[i - 2U];
        const DriveSample& middle = drive.samples[i - 1U];
        const DriveSample& last = drive.samples[i];
        const double change = std::abs(last.*force - 2.0 * (middle.*force) + first.*force);
        if (follows(first, middle) && follows(middle, last) && std::isfinite(change)) {
            changes.push_back(change);
        }
    }
    if (changes.empty()) {
        return 0.0;
    }
    const auto middle = changes.begin() + static_cast<std::ptrdiff_t>(changes.size() / 2U);
    std::nth_element(changes.begin(), middle, changes.end());
    return *middle / (median_of_noise * second_difference_of_noise);
}

double smallest_speed_step_mps(const std::vector<Drive>& drives) {
    std::size_t steps = 0U;
    double smallest_mps = std::numeric_limits<double>::infinity();
    for (const Drive& drive : drives) {
        for (std::size_t i = 1U; i < drive.samples.size(); ++i) {
            const double step_mps = std::abs(drive.samples[i].speed_mps - drive.samples[i - 1U].speed_mps);
            if (step_mps > rounding_mps) {
                ++steps;
                smallest_mps = std::min(smallest_mps, step_mps);
            }
        }
    }
    return steps >= least_steps ? smallest_mps : 0.0;
}

}  // namespace

SensorQuality sensor_quality(const std::vector<Drive>& ramps, const std::vector<Drive>& dynamics) {
    std::vector<Drive> drives = ramps;
    drives.insert(drives.end(), dynamics.begin(), dynamics.end());
    double noise_mps2 = 0.0;
    for (const Drive& drive : drives) {
        noise_mps2 = std::max({noise_mps2, noise_rms(drive, &DriveSample::lateral_acceleration_mps2),
                               noise_rms(drive, &DriveSample::vertical_acceleration_mps2)});
    }
    const double step_mps = smallest_speed_step_mps(drives);
    return {noise_mps2 > quiet_mps2 ? noise_mps2 : 0.0, step_mps > fine_step_mps ? step_mps : 0.0};
}

}  // namespace sil
