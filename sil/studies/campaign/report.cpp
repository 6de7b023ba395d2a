// Report: rows grouped and judged.
#include "sil/studies/campaign/report.hpp"

#include <algorithm>
#include <map>

namespace sil {
namespace {

void count(RunGroup& group, const RecordedCampaignRun& run) {
    ++group.runs;
    const RunKind kind = kind_of(run);
    group.calm += kind == RunKind::calm ? 1U : 0U;
    group.between += kind == RunKind::between ? 1U : 0U;
    group.lifted += kind == RunKind::lifted ? 1U : 0U;
    group.brief_lifts += kind != RunKind::lifted && run.brief_two_wheel_lift_time_s ? 1U : 0U;
}

std::vector<std::optional<CurvePoint>> best_of(const std::vector<CurvePoint>& curve) {
    std::vector<std::optional<CurvePoint>> best;
    for (const double limit : false_alarm_limits) {
        best.push_back(best_at(curve, limit));
    }
    return best;
}

RunGroup judge(std::string name, const std::vector<RecordedCampaignRun>& runs,
               const std::vector<std::string>& index_names) {
    RunGroup group;
    group.name = std::move(name);
    for (const RecordedCampaignRun& run : runs) {
        count(group, run);
    }
    group.judgements.push_back({"warning", detection_of_warning(runs), {}});
    for (std::size_t i = 0U; i < index_names.size(); ++i) {
        group.judgements.push_back(
            {index_names[i], detection_of_index(runs, i), best_of(detection_curve(runs, i))});
    }
    return group;
}

std::vector<RunGroup> judge_by(const RowTable& table, std::string RecordedCampaignRun::* key) {
    std::map<std::string, std::vector<RecordedCampaignRun>> groups;
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
    report.all = judge("all", table.runs, table.index_names);
    report.vehicles = judge_by(table, &RecordedCampaignRun::vehicle);
    report.manoeuvres = judge_by(table, &RecordedCampaignRun::manoeuvre);
    for (std::size_t i = 0U; i < table.index_names.size(); ++i) {
        report.curves.push_back(detection_curve(table.runs, i));
    }
    return report;
}

}  // namespace sil
