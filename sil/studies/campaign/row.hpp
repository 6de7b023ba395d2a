// Row: what a campaign keeps of one run, and its line in runs.csv.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sil/results/warning_judgement.hpp"
#include "sil/studies/campaign/draw.hpp"
#include "sil/studies/campaign/index_score.hpp"
#include "sil/studies/campaign/outcome.hpp"

namespace sil {

struct CampaignRow {
    RunDraw draw{};
    std::string vehicle{};   // its file's name without folder and ending
    std::string in_class{};  // as the settings say
    std::string manoeuvre{};
    double speed_kmh{0.0};
    Outcome outcome{};
    std::optional<double> warning_time_s{};  // of the firmware's first warning
    WarningJudgement judgement{};            // of the firmware's warning
    std::uint64_t codes{0U};                 // that the firmware confirmed in it; see code_names
    std::vector<IndexScore> indices{};       // in the order of campaign_indices()
};

// The columns of all rows, without the end of the line. docs/drives.md says what they mean.
std::string row_header();

// The row as a line of the CSV, without its end; the same text for the same row.
std::string row_line(const CampaignRow& row);

}  // namespace sil
