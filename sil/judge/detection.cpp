#include "sil/judge/detection.hpp"

#include <algorithm>

namespace sil {

WarningInRun warning_in_run(const std::optional<double>& lead_s, bool alarm) {
    return {is_warned(lead_s), is_warned(lead_s, early_s), is_warned(lead_s, very_early_s), alarm};
}

void DetectionCounts::add(const RunKind& run, const std::optional<double>& lead_s, bool alarm) {
    add(run, warning_in_run(lead_s, alarm));
    if (run.lifted) {
        lead_times_s_.push_back(lead_s.value_or(0.0));
    }
}

void DetectionCounts::add(const RunKind& run, const WarningInRun& warning) {
    if (run.lifted) {
        warned_.add(run.vehicle, warning.warned);
        warned_100ms_.add(run.vehicle, warning.warned_100ms);
        warned_200ms_.add(run.vehicle, warning.warned_200ms);
        return;
    }
    alarms_[static_cast<std::size_t>(run.band)].add(run.vehicle, warning.alarm);
    if (is_calm(run.lifted, run.band)) {
        false_alarms_.add(run.vehicle, warning.alarm);
    }
}

Detection DetectionCounts::detection() const {
    Detection detection;
    detection.warned = warned_.share();
    detection.warned_100ms = warned_100ms_.share();
    detection.warned_200ms = warned_200ms_.share();
    detection.false_alarms = false_alarms_.share();
    std::transform(alarms_.begin(), alarms_.end(), detection.alarms.begin(),
                   [](const ShareByVehicle& share) { return share.share(); });
    detection.lead_times_s = lead_times_s_;
    detection.median_lead_s = quantile(lead_times_s_, 0.5);
    detection.tenth_lead_s = quantile(lead_times_s_, 0.1);
    return detection;
}

}  // namespace sil
