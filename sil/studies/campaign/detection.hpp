// Detection: how well a warning tells runs that lift two wheels from runs that do not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sil/results/warning_judgement.hpp"
#include "sil/studies/campaign/row_table.hpp"
#include "sil/studies/campaign/statistics.hpp"

namespace sil {

inline constexpr std::size_t band_count = sizeof(load_bands) / sizeof(load_bands[0]);

bool is_lifted(const RecordedCampaignRun& run);

// A run is calm when its largest |LTR| stays below 0.9: no wheel lifts.
bool is_calm(const RecordedCampaignRun& run);

// What came of one warning over many runs.
struct Detection {
    Share warned{};                          // of two-wheel lift-offs: is_warned(lead)
    Share warned_100ms{};                    // with a lead of at least early_s
    Share warned_200ms{};                    // very_early_s
    Share false_alarms{};                    // of calm runs
    std::array<Share, band_count> alarms{};  // of the runs of each LoadBand
    // Of all two-wheel lift-offs, 0 for those that were not warned of.
    std::vector<double> lead_times_s{};
    std::optional<double> median_lead_s{};  // of these
    std::optional<double> tenth_lead_s{};   // their 10th percentile
};

// Some of a table's runs, with what every judgement of them asks for side by side: a million runs are gone
// through again and again. The table must live on.
class RunList {
 public:
    struct Entry {
        const RecordedCampaignRun* run{nullptr};
        std::uint32_t vehicle{0U};  // numbered in the order of their names, from 0
        bool lifted{false};
        LoadBand band{LoadBand::below_0_7};
    };

    explicit RunList(const std::vector<const RecordedCampaignRun*>& runs);

    const std::vector<Entry>& entries() const { return entries_; }
    std::size_t vehicles() const { return vehicles_; }

 private:
    std::vector<Entry> entries_{};
    std::size_t vehicles_{0U};
};

// Of the firmware's warning state.
Detection detection_of_warning(const RunList& runs);

struct CurvePoint {
    double threshold{0.0};  // alarm from here on
    Share false_alarms{};
    std::array<Share, band_count> alarms{};
    Share warned{};
    Share warned_100ms{};
    Share warned_200ms{};
};

// An index over some runs, which must live on.
class IndexOverRuns {
 public:
    IndexOverRuns(const RunList& runs, std::size_t index);

    // With its threshold at 1.
    Detection at_one() const;

    // With another threshold; its leads are not known.
    Detection at(double threshold) const;

    // Over thresholds, from the highest, which warns of the fewest runs, downwards: one point for each
    // threshold at which something changes.
    std::vector<CurvePoint> curve() const;

 private:
    const RunList& runs_;
    std::vector<RecordedIndex> recorded_{};  // of the runs, in their order
};

// The point of the most detection among those with a share of false alarms of at most `limit`; none when
// there are no calm or no lifted runs, or when each threshold has more false alarms.
std::optional<CurvePoint> best_at(const std::vector<CurvePoint>& curve, double limit);

}  // namespace sil
