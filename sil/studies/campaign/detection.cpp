#include "sil/studies/campaign/detection.hpp"

#include <algorithm>
#include <functional>

namespace sil {
namespace {

std::size_t band_index(const RecordedCampaignRun& run) {
    return static_cast<std::size_t>(load_band(run.largest_ltr));
}

// What one warning did in one run.
struct Statement {
    bool warned{false};
    bool warned_100ms{false};
    bool warned_200ms{false};
    bool alarm{false};
};

Statement of_lead(const std::optional<double>& lead_s, bool alarm) {
    return {is_warned(lead_s), is_warned(lead_s, early_s), is_warned(lead_s, very_early_s), alarm};
}

template <typename StatementOf>
Detection detection_of(const std::vector<RecordedCampaignRun>& runs, const StatementOf& statement_of) {
    ShareByVehicle warned;
    ShareByVehicle warned_100ms;
    ShareByVehicle warned_200ms;
    ShareByVehicle false_alarms;
    std::array<ShareByVehicle, band_count> alarms;
    for (const RecordedCampaignRun& run : runs) {
        const Statement statement = statement_of(run);
        if (is_lifted(run)) {
            warned.add(run.vehicle, statement.warned);
            warned_100ms.add(run.vehicle, statement.warned_100ms);
            warned_200ms.add(run.vehicle, statement.warned_200ms);
            continue;
        }
        alarms[band_index(run)].add(run.vehicle, statement.alarm);
        if (is_calm(run)) {
            false_alarms.add(run.vehicle, statement.alarm);
        }
    }
    Detection detection;
    detection.warned = warned.share();
    detection.warned_100ms = warned_100ms.share();
    detection.warned_200ms = warned_200ms.share();
    detection.false_alarms = false_alarms.share();
    std::transform(alarms.begin(), alarms.end(), detection.alarms.begin(),
                   [](const ShareByVehicle& share) { return share.share(); });
    return detection;
}

template <typename LeadOf>
std::vector<double> leads_of(const std::vector<RecordedCampaignRun>& runs, const LeadOf& lead_of) {
    std::vector<double> leads_s;
    for (const RecordedCampaignRun& run : runs) {
        if (is_lifted(run)) {
            leads_s.push_back(lead_of(run).value_or(0.0));
        }
    }
    return leads_s;
}

// The thresholds up to which runs of one kind are warned of, sorted.
struct SortedThresholds {
    std::vector<double> values{};

    void sort() { std::sort(values.begin(), values.end()); }
    Share at(double threshold) const {
        const auto first = std::lower_bound(values.begin(), values.end(), threshold);
        return {static_cast<std::size_t>(values.end() - first), values.size()};
    }
};

}  // namespace

bool is_lifted(const RecordedCampaignRun& run) {
    return run.two_wheel_lift_time_s.has_value();
}

bool is_calm(const RecordedCampaignRun& run) {
    return !is_lifted(run) && load_band(run.largest_ltr) != LoadBand::from_0_9;
}

Detection detection_of_warning(const std::vector<RecordedCampaignRun>& runs) {
    Detection detection = detection_of(
        runs, [](const RecordedCampaignRun& run) { return of_lead(run.lead_s, run.warnings > 0U); });
    detection.lead_times_s = leads_of(runs, [](const RecordedCampaignRun& run) { return run.lead_s; });
    return detection;
}

Detection detection_of_index(const std::vector<RecordedCampaignRun>& runs, std::size_t index) {
    Detection detection = detection_of(runs, [index](const RecordedCampaignRun& run) {
        return of_lead(run.indices[index].lead_s, run.indices[index].threshold >= 1.0);
    });
    detection.lead_times_s =
        leads_of(runs, [index](const RecordedCampaignRun& run) { return run.indices[index].lead_s; });
    return detection;
}

Detection detection_at(const std::vector<RecordedCampaignRun>& runs, std::size_t index, double threshold) {
    return detection_of(runs, [index, threshold](const RecordedCampaignRun& run) {
        const RecordedIndex& recorded = run.indices[index];
        return Statement{recorded.threshold >= threshold, recorded.threshold_100ms >= threshold,
                         recorded.threshold_200ms >= threshold, recorded.threshold >= threshold};
    });
}

std::vector<CurvePoint> detection_curve(const std::vector<RecordedCampaignRun>& runs, std::size_t index) {
    SortedThresholds calm;
    std::array<SortedThresholds, band_count> bands;
    SortedThresholds lifted;
    SortedThresholds lifted_100ms;
    SortedThresholds lifted_200ms;
    for (const RecordedCampaignRun& run : runs) {
        const RecordedIndex& recorded = run.indices[index];
        if (is_lifted(run)) {
            lifted.values.push_back(recorded.threshold);
            lifted_100ms.values.push_back(recorded.threshold_100ms);
            lifted_200ms.values.push_back(recorded.threshold_200ms);
            continue;
        }
        bands[band_index(run)].values.push_back(recorded.threshold);
        if (is_calm(run)) {
            calm.values.push_back(recorded.threshold);
        }
    }
    std::vector<double> thresholds;
    const auto take = [&thresholds](SortedThresholds& kind) {
        kind.sort();
        thresholds.insert(thresholds.end(), kind.values.begin(), kind.values.end());
    };
    for (SortedThresholds* kind : {&calm, &lifted, &lifted_100ms, &lifted_200ms}) {
        take(*kind);
    }
    std::for_each(bands.begin(), bands.end(), take);
    std::sort(thresholds.begin(), thresholds.end(), std::greater<>{});
    thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
    // 0 is no threshold: the run is warned of at none.
    while (!thresholds.empty() && thresholds.back() <= 0.0) {
        thresholds.pop_back();
    }

    std::vector<CurvePoint> curve;
    for (const double threshold : thresholds) {
        CurvePoint point;
        point.threshold = threshold;
        point.false_alarms = calm.at(threshold);
        std::transform(bands.begin(), bands.end(), point.alarms.begin(),
                       [threshold](const SortedThresholds& band) { return band.at(threshold); });
        point.warned = lifted.at(threshold);
        point.warned_100ms = lifted_100ms.at(threshold);
        point.warned_200ms = lifted_200ms.at(threshold);
        curve.push_back(point);
    }
    return curve;
}

std::optional<CurvePoint> best_at(const std::vector<CurvePoint>& curve, double limit) {
    std::optional<CurvePoint> best;
    for (const CurvePoint& point : curve) {
        // Lower thresholds only warn of more; of equals the highest is kept. Without calm runs the share of
        // false alarms is no number, which no limit allows.
        const bool allowed = point.warned.total > 0U && point.false_alarms.value() <= limit;
        const bool better = !best || point.warned.count > best->warned.count ||
                            point.warned_100ms.count > best->warned_100ms.count ||
                            point.warned_200ms.count > best->warned_200ms.count;
        if (allowed && better) {
            best = point;
        }
    }
    return best;
}

}  // namespace sil
