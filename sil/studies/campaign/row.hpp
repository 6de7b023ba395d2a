// Row: what a campaign keeps of one run, and its line in runs.csv.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sil/judge/index_score.hpp"
#include "sil/judge/warning_judgement.hpp"
#include "sil/studies/campaign/draw.hpp"
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

struct RowColumn {
    enum class Kind : std::uint8_t { text, count, yes_or_no, number };  // yes_or_no: 1 or 0

    std::string name{};
    Kind kind{Kind::text};
    std::string unit{};  // empty: none
    std::string meaning{};
};

// All columns in their order, also as JSON: an array of objects with name, kind, unit and meaning.
std::vector<RowColumn> row_columns();
std::string row_columns_json();

// Their names, without the end of the line.
std::string row_header();

// The row as a line of the CSV, without its end; the same text for the same row.
std::string row_line(const CampaignRow& row);

}  // namespace sil
