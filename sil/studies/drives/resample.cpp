#include "sil/studies/drives/resample.hpp"

#include <cmath>
#include <cstddef>

#include "sil/simulation/pace.hpp"
#include "sil/studies/drives/drive_columns.hpp"

namespace sil {
namespace {

// Times in files are rounded; a sample this near counts as one at the very instant.
constexpr double same_time_s = 1.0e-6;

struct Weighted {
    const DriveSample* sample;
    double weight;
};

// NaN where any of the samples is not available.
DriveSample mean(const std::vector<Weighted>& parts, double time_s) {
    double sum = 0.0;
    for (const Weighted& part : parts) {
        sum += part.weight;
    }
    DriveSample result;
    for (const DriveQuantity& quantity : drive_quantities()) {
        double value = 0.0;
        for (const Weighted& part : parts) {
            DriveSample sample = *part.sample;
            value += quantity.value(sample) * (part.weight / sum);
        }
        quantity.value(result) = value;
    }
    result.time_s = time_s;
    return result;
}

class Resampler {
 public:
    explicit Resampler(const std::vector<DriveSample>& samples) : samples_{samples} {}

    // Times must not decrease from call to call.
    DriveCycle at(double time_s) {
        while (before_ + 2U < samples_.size() && samples_[before_ + 1U].time_s <= time_s) {
            ++before_;
        }
        const DriveSample& before = samples_[before_];
        const DriveSample& after = samples_[before_ + 1U];
        const double step_s = after.time_s - before.time_s;
        const double share = (time_s - before.time_s) / step_s;
        const DriveSample& nearest = share < 0.5 ? before : after;
        const double distance_s = std::fabs(nearest.time_s - time_s);
        if (step_s > longest_bridged_gap_s && distance_s > same_time_s) {
            return across_gap(nearest, distance_s, time_s);
        }
        // A hair's breadth below 10 ms is a clock's error, not another rate.
        if (step_s < 0.95 * cycle_time_s) {
            return {true, triangle(time_s)};
        }
        if (distance_s <= same_time_s) {
            return {true, mean({{&nearest, 1.0}}, time_s)};
        }
        return {true, mean({{&before, 1.0 - share}, {&after, share}}, time_s)};
    }

 private:
    static DriveCycle across_gap(const DriveSample& nearest, double distance_s, double time_s) {
        if (distance_s <= 0.5 * cycle_time_s) {
            return {true, mean({{&nearest, 1.0}}, time_s)};
        }
        DriveCycle silent{false, {}};
        silent.sample.time_s = time_s;
        return silent;
    }

    DriveSample triangle(double time_s) const {
        std::vector<Weighted> parts;
        std::size_t first = before_;
        while (first > 0U && samples_[first - 1U].time_s > time_s - cycle_time_s) {
            --first;
        }
        for (std::size_t index = first; index < samples_.size(); ++index) {
            const double weight = 1.0 - std::fabs(samples_[index].time_s - time_s) / cycle_time_s;
            if (weight > same_time_s) {
                parts.push_back({&samples_[index], weight});
            } else if (samples_[index].time_s > time_s) {
                break;
            }
        }
        return mean(parts, time_s);
    }

    const std::vector<DriveSample>& samples_;
    std::size_t before_{0U};
};

}  // namespace

std::vector<DriveCycle> to_cycles(const Drive& drive) {
    const double start_s = drive.samples.front().time_s;
    const double end_s = drive.samples.back().time_s;
    Resampler resampler{drive.samples};
    std::vector<DriveCycle> cycles;
    for (std::size_t number = 0U;; ++number) {
        const double time_s = start_s + static_cast<double>(number) * cycle_time_s;
        if (time_s > end_s + same_time_s) {
            return cycles;
        }
        cycles.push_back(resampler.at(time_s));
    }
}

}  // namespace sil
