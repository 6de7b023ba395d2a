// Run list: some of a campaign's runs, and how well its warning and each index detect their lift-offs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sil/judge/detection.hpp"
#include "sil/studies/campaign/row_table.hpp"

namespace sil {

bool is_lifted(const RecordedCampaignRun& run);

bool is_calm(const RecordedCampaignRun& run);

// Some of a table's runs, with what every judgement of them asks for side by side: a million runs are gone
// through again and again. The table must live on.
class RunList {
 public:
    struct Entry {
        const RecordedCampaignRun* run{nullptr};
        RunKind kind{};  // vehicles are numbered in the order of their names
    };

    explicit RunList(const std::vector<const RecordedCampaignRun*>& runs);

    const std::vector<Entry>& entries() const { return entries_; }
    std::size_t vehicles() const { return vehicles_; }

 private:
    std::vector<Entry> entries_{};
    std::size_t vehicles_{0U};
};

// Times of the firmware's warning state.
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
    std::vector<IndexScore> recorded_{};  // of the runs, in their order
};

// The point of the most detection among those with a share of false alarms of at most `limit`; none when
// there are no calm or no lifted runs, or when each threshold has more false alarms.
std::optional<CurvePoint> best_at(const std::vector<CurvePoint>& curve, double limit);

}  // namespace sil
