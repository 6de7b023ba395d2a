// Detection: how well a warning tells runs that lift two wheels from runs that lift none.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sil/studies/campaign/row_table.hpp"
#include "sil/studies/campaign/statistics.hpp"

namespace sil {

// A run is calm while its largest |LTR| stays below this: no wheel lifts.
inline constexpr double calm_ltr = 0.9;
// Calm runs from here on are hard to tell from others; the rest of them say little about an index.
inline constexpr double hard_ltr = 0.7;

enum class RunKind { calm, between, lifted };

// `lifted`: both wheels of one side carried nothing for 50 ms or more. `between`: neither that nor calm.
RunKind kind_of(const RecordedCampaignRun& run);

// What came of one warning over many runs.
struct Detection {
    Share warned{};                      // of two-wheel lift-offs, before they happen or as they do
    Share warned_100ms{};                // 0.1 s before them or earlier
    Share false_alarms{};                // of calm runs
    Share hard_false_alarms{};           // of calm runs with a largest |LTR| of hard_ltr or more
    Share alarms_between{};              // of the runs in between
    std::vector<double> lead_times_s{};  // of all two-wheel lift-offs that were warned of, negative if late
};

// Of the firmware's warning state.
Detection detection_of_warning(const std::vector<RecordedCampaignRun>& runs);

// Of an index with its threshold at 1.
Detection detection_of_index(const std::vector<RecordedCampaignRun>& runs, std::size_t index);

struct CurvePoint {
    double threshold{0.0};  // alarm from here on
    Share false_alarms{};
    Share alarms_between{};
    Share warned{};
    Share warned_100ms{};
};

// An index over thresholds, from the highest, which warns of the fewest runs, downwards: one point for each
// threshold at which something changes.
std::vector<CurvePoint> detection_curve(const std::vector<RecordedCampaignRun>& runs, std::size_t index);

// The point of the most detection among those with a share of false alarms of at most `limit`; none when
// there are no calm or no lifted runs, or when each threshold has more false alarms.
std::optional<CurvePoint> best_at(const std::vector<CurvePoint>& curve, double limit);

}  // namespace sil
