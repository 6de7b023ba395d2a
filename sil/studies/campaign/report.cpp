// Report: rows grouped and judged.
#include "sil/studies/campaign/report.hpp"

#include <map>

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

std::vector<std::optional<BestThreshold>> best_of(const IndexOverRuns& index) {
    const std::vector<CurvePoint> curve = index.curve();
    std::vector<std::optional<BestThreshold>> best;
    for (const double limit : false_alarm_limits) {
        const std::optional<CurvePoint> point = best_at(curve, limit);
        best.push_back(point ? std::optional{BestThreshold{point->threshold, index.at(point->threshold)}}
                             : std::nullopt);
    }
    return best;
}

RunGroup judge(std::string name, const RunList& runs, const std::vector<std::string>& index_names) {
    RunGroup group;
    group.name = std::move(name);
    for (const RunList::Entry& entry : runs.entries()) {
        count(group, *entry.run);
    }
    group.vehicles = runs.vehicles();
    group.judgements.push_back({"warning", detection_of_warning(runs), {}});
    for (std::size_t i = 0U; i < index_names.size(); ++i) {
        const IndexOverRuns index{runs, i};
        group.judgements.push_back({index_names[i], index.at_one(), best_of(index)});
    }
    return group;
}

using Runs = std::vector<const RecordedCampaignRun*>;

std::vector<RunGroup> judge_by(const Runs& runs, Name RecordedCampaignRun::* key,
                               const std::vector<std::string>& index_names) {
    std::map<Name, Runs> groups;
    for (const RecordedCampaignRun* run : runs) {
        groups[run->*key].push_back(run);
    }
    std::vector<RunGroup> judged;
    for (const auto& [name, members] : groups) {
        judged.push_back(judge(name, RunList{members}, index_names));
        for (Judgement& judgement : judged.back().judgements) {
            judgement.detection.lead_times_s = std::vector<double>{};  // they are drawn of all runs only
        }
    }
    return judged;
}

}  // namespace

CampaignReport make_report(const RowTable& table, std::uint64_t runs_wanted) {
    CampaignReport report;
    report.runs_wanted = runs_wanted;
    Runs drawn;
    for (const RecordedCampaignRun& run : table.runs) {
        if (run.manoeuvre == ordinary_driving_name) {
            ++report.ordinary_runs;
            count(report.ordinary, run);
        } else {
            drawn.push_back(&run);
        }
    }
    const RunList all{drawn};
    report.all = judge("all", all, table.index_names);
    report.vehicles = judge_by(drawn, &RecordedCampaignRun::vehicle, table.index_names);
    report.classes = judge_by(drawn, &RecordedCampaignRun::in_class, table.index_names);
    if (report.classes.size() == 1U && report.classes.front().name.empty()) {
        report.classes.clear();
    }
    report.manoeuvres = judge_by(drawn, &RecordedCampaignRun::manoeuvre, table.index_names);
    for (std::size_t i = 0U; i < table.index_names.size(); ++i) {
        report.curves.push_back(IndexOverRuns{all, i}.curve());
    }
    return report;
}

}  // namespace sil
