// Report: rows grouped and judged.
#include "sil/studies/campaign/report.hpp"

#include <map>
#include <set>

#include "sil/world/manoeuvres/mixed_driving.hpp"

namespace sil {
namespace {

void count(TimeAccount& time, const RecordedCampaignRun& run) {
    time.duration_s += run.end_time_s;
    time.distance_m += run.distance_m;
    time.wrong_side_s += run.wrong_side_s;
    time.unavailable_s += run.unavailable_s;
    time.alarms += run.warnings;
    time.advisories += run.advisories;
    time.coded_runs += run.has_code ? 1U : 0U;
}

void count(RunGroup& group, const RecordedCampaignRun& run) {
    ++group.runs;
    count(group.time, run);
    if (is_lifted(run)) {
        ++group.lifted;
        return;
    }
    group.calm += is_calm(run) ? 1U : 0U;
    ++group.bands[static_cast<std::size_t>(load_band(run.largest_ltr))];
    group.brief_lifts += run.brief_two_wheel_lift_time_s ? 1U : 0U;
}

std::vector<std::optional<BestThreshold>> best_of(const std::vector<RecordedCampaignRun>& runs,
                                                  std::size_t index) {
    const std::vector<CurvePoint> curve = detection_curve(runs, index);
    std::vector<std::optional<BestThreshold>> best;
    for (const double limit : false_alarm_limits) {
        const std::optional<CurvePoint> point = best_at(curve, limit);
        best.push_back(point ? std::optional{BestThreshold{point->threshold,
                                                           detection_at(runs, index, point->threshold)}}
                             : std::nullopt);
    }
    return best;
}

RunGroup judge(std::string name, const std::vector<RecordedCampaignRun>& runs,
               const std::vector<std::string>& index_names) {
    RunGroup group;
    group.name = std::move(name);
    std::set<Name> vehicles;
    for (const RecordedCampaignRun& run : runs) {
        count(group, run);
        vehicles.insert(run.vehicle);
    }
    group.vehicles = vehicles.size();
    group.judgements.push_back({"warning", detection_of_warning(runs), {}});
    for (std::size_t i = 0U; i < index_names.size(); ++i) {
        group.judgements.push_back({index_names[i], detection_of_index(runs, i), best_of(runs, i)});
    }
    return group;
}

std::vector<RunGroup> judge_by(const RowTable& table, Name RecordedCampaignRun::* key) {
    std::map<Name, std::vector<RecordedCampaignRun>> groups;
    for (const RecordedCampaignRun& run : table.runs) {
        groups[run.*key].push_back(run);
    }
    std::vector<RunGroup> judged;
    for (const auto& [name, runs] : groups) {
        judged.push_back(judge(name, runs, table.index_names));
    }
    return judged;
}

}  // namespace

CampaignReport make_report(const RowTable& table, std::uint64_t runs_wanted) {
    CampaignReport report;
    report.runs_wanted = runs_wanted;
    RowTable drawn{table.index_names, {}};
    for (const RecordedCampaignRun& run : table.runs) {
        if (run.manoeuvre == ordinary_driving_name) {
            ++report.ordinary_runs;
            count(report.ordinary, run);
        } else {
            drawn.runs.push_back(run);
        }
    }
    report.all = judge("all", drawn.runs, drawn.index_names);
    report.vehicles = judge_by(drawn, &RecordedCampaignRun::vehicle);
    report.classes = judge_by(drawn, &RecordedCampaignRun::in_class);
    if (report.classes.size() == 1U && report.classes.front().name.empty()) {
        report.classes.clear();
    }
    report.manoeuvres = judge_by(drawn, &RecordedCampaignRun::manoeuvre);
    for (std::size_t i = 0U; i < drawn.index_names.size(); ++i) {
        report.curves.push_back(detection_curve(drawn.runs, i));
    }
    return report;
}

}  // namespace sil
