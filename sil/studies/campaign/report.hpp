// Report: what a campaign's rows say about the warning and every index, as JSON, Markdown, CSV and pictures'
// data.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sil/studies/campaign/run_list.hpp"

namespace sil {

// At which shares of false alarms the report looks up what an index could do.
inline constexpr double false_alarm_limits[] = {0.001, 0.005, 0.01, 0.02, 0.05};

// An index with the threshold that is best at one of false_alarm_limits.
struct BestThreshold {
    double threshold{0.0};
    Detection detection{};
};

// One index, or the firmware's warning, over some runs.
struct Judgement {
    std::string name{};
    Detection detection{};                             // the warning itself, or the index at threshold 1
    std::vector<std::optional<BestThreshold>> best{};  // at false_alarm_limits; empty for the warning
};

inline constexpr double hour_s = 3600.0;
inline constexpr double thousand_km_m = 1.0e6;

// Warnings of the firmware over the time of some runs.
struct TimeAccount {
    double duration_s{0.0};
    double distance_m{0.0};
    double wrong_side_s{0.0};
    double unavailable_s{0.0};
    std::size_t alarms{0U};
    std::size_t advisories{0U};
    std::size_t coded_runs{0U};  // with a confirmed diagnostic code
};

// Some runs: all, those of one vehicle, of one class of vehicles, or of one manoeuvre.
struct RunGroup {
    std::string name{};
    std::size_t runs{0U};
    std::size_t vehicles{0U};
    std::size_t calm{0U};
    std::array<std::size_t, band_count> bands{};  // runs without two-wheel lift-off by LoadBand
    std::size_t lifted{0U};
    std::size_t brief_lifts{0U};  // runs without a lasting two-wheel lift-off but with a brief one
    TimeAccount time{};
    std::vector<Judgement> judgements{};  // the warning first, then the indices
};

struct CampaignReport {
    std::uint64_t runs_wanted{0U};  // more than there are: the campaign has not finished
    RunGroup all{};
    std::vector<RunGroup> vehicles{};
    std::vector<RunGroup> classes{};  // none where no vehicle has one
    std::vector<RunGroup> manoeuvres{};
    std::vector<std::vector<CurvePoint>> curves{};  // of the indices, over all runs
    // Ordinary driving (sil/world/manoeuvres/mixed_driving.hpp) counts by the hour and kilometre, and in no
    // share above.
    std::size_t ordinary_runs{0U};
    TimeAccount ordinary{};

    bool complete() const { return all.runs + ordinary_runs >= runs_wanted; }
};

CampaignReport make_report(const RowTable& table, std::uint64_t runs_wanted);

// Points that a picture cannot tell apart are there once; the first and the last always.
std::vector<CurvePoint> distinct_points(const std::vector<CurvePoint>& curve);

// The share of two-wheel lift-offs with at least this lead.
struct LeadShare {
    double lead_s{0.0};
    double share{0.0};
};

// From the longest lead that there is downwards; lift-offs that were not warned of are left out.
std::vector<LeadShare> lead_shares(const Judgement& judgement, std::size_t lifted);

std::string report_json(const CampaignReport& report);
std::string report_markdown(const CampaignReport& report);

// Writes report.json, report.md, curves.csv, leads.csv and report.gp (what the pictures need besides) into
// the folder. Throws std::runtime_error when the system refuses.
void write_report(const CampaignReport& report, const std::filesystem::path& folder);

}  // namespace sil
