#include "sil/studies/campaign/detection.hpp"

#include <algorithm>
#include <functional>

#include "sil/studies/campaign/times.hpp"

namespace sil {
namespace {

using TimeOf = std::function<std::optional<double>(const RecordedCampaignRun&)>;

void add_lifted(Detection& detection, double lift_time_s, const std::optional<double>& time_s) {
    const double lead_s = time_s ? lift_time_s - *time_s : -1.0;
    detection.warned.add(lead_s >= -rounding_s);
    detection.warned_100ms.add(lead_s >= early_s - rounding_s);
    if (time_s) {
        detection.lead_times_s.push_back(lead_s);
    }
}

Detection detection_of(const std::vector<RecordedCampaignRun>& runs, const TimeOf& time_of) {
    Detection detection;
    for (const RecordedCampaignRun& run : runs) {
        const std::optional<double> time_s = time_of(run);
        switch (kind_of(run)) {
            case RunKind::lifted:
                add_lifted(detection, *run.two_wheel_lift_time_s, time_s);
                break;
            case RunKind::calm:
                detection.false_alarms.add(time_s.has_value());
                if (run.largest_ltr >= hard_ltr) {
                    detection.hard_false_alarms.add(time_s.has_value());
                }
                break;
            case RunKind::between:
                detection.alarms_between.add(time_s.has_value());
                break;
        }
    }
    return detection;
}

// The peaks that decide at which thresholds runs of one kind are warned of, sorted.
struct SortedPeaks {
    std::vector<double> values{};

    void sort() { std::sort(values.begin(), values.end()); }
    Share at(double threshold) const {
        const auto first = std::lower_bound(values.begin(), values.end(), threshold);
        return {static_cast<std::size_t>(values.end() - first), values.size()};
    }
};

}  // namespace

RunKind kind_of(const RecordedCampaignRun& run) {
    if (run.two_wheel_lift_time_s) {
        return RunKind::lifted;
    }
    return run.largest_ltr < calm_ltr ? RunKind::calm : RunKind::between;
}

Detection detection_of_warning(const std::vector<RecordedCampaignRun>& runs) {
    return detection_of(runs, [](const RecordedCampaignRun& run) { return run.warning_time_s; });
}

Detection detection_of_index(const std::vector<RecordedCampaignRun>& runs, std::size_t index) {
    return detection_of(runs, [index](const RecordedCampaignRun& run) { return run.indices[index].time_s; });
}

std::vector<CurvePoint> detection_curve(const std::vector<RecordedCampaignRun>& runs, std::size_t index) {
    SortedPeaks calm;
    SortedPeaks between;
    SortedPeaks lifted;
    SortedPeaks lifted_100ms;
    for (const RecordedCampaignRun& run : runs) {
        const RecordedIndex& recorded = run.indices[index];
        switch (kind_of(run)) {
            case RunKind::calm:
                calm.values.push_back(recorded.peak);
                break;
            case RunKind::between:
                between.values.push_back(recorded.peak);
                break;
            case RunKind::lifted:
                lifted.values.push_back(recorded.peak);
                lifted_100ms.values.push_back(recorded.peak_100ms_before);
                break;
        }
    }
    std::vector<double> thresholds;
    for (SortedPeaks* peaks : {&calm, &between, &lifted, &lifted_100ms}) {
        peaks->sort();
        thresholds.insert(thresholds.end(), peaks->values.begin(), peaks->values.end());
    }
    std::sort(thresholds.begin(), thresholds.end(), std::greater<>{});
    thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());

    std::vector<CurvePoint> curve;
    for (const double threshold : thresholds) {
        curve.push_back({threshold, calm.at(threshold), between.at(threshold), lifted.at(threshold),
                         lifted_100ms.at(threshold)});
    }
    return curve;
}

std::optional<CurvePoint> best_at(const std::vector<CurvePoint>& curve, double limit) {
    std::optional<CurvePoint> best;
    for (const CurvePoint& point : curve) {
        // Lower thresholds only warn of more; of equals the highest is kept.
        const bool allowed =
            point.false_alarms.total > 0U && point.warned.total > 0U && point.false_alarms.value() <= limit;
        const bool better = !best || point.warned.count > best->warned.count ||
                            point.warned_100ms.count > best->warned_100ms.count;
        if (allowed && better) {
            best = point;
        }
    }
    return best;
}

}  // namespace sil
