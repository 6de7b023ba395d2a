// Row: what a campaign keeps of one run, and its line in runs.csv.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sil/campaign/draw.hpp"
#include "sil/campaign/outcome.hpp"

namespace sil {

// How high an index came. A peak counts only what lasted as many cycles as the firmware wants for a warning
// (warning_confirmation_s), so that an index driving the warning at threshold x would have warned exactly in
// the runs whose peak is at least x.
struct IndexPeaks {
    double whole{0.0};         // over the run, but not beyond two-wheel lift-off
    double before_100ms{0.0};  // up to 0.1 s before two-wheel lift-off; as `whole` when there is none
    std::optional<double> first_time_s{};  // at level 1, within the time of `whole`
};

struct CampaignRow {
    RunDraw draw{};
    std::string vehicle{};  // its file's name without folder and ending
    std::string manoeuvre{};
    double speed_kmh{0.0};
    Outcome outcome{};
    std::optional<double> warning_time_s{};  // of the firmware's state machine
    std::vector<IndexPeaks> indices{};       // in the order of campaign_indices()
};

// The columns of all rows, without the end of the line. docs/campaign.md says what they mean.
std::string row_header();

// The row as a line of the CSV, without its end; the same text for the same row.
std::string row_line(const CampaignRow& row);

}  // namespace sil
