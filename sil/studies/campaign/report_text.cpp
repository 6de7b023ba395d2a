// Report text: the judgements as JSON and as Markdown.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sil/studies/campaign/report.hpp"

namespace sil {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(std::round(value * 1e6) / 1e6) : Json(nullptr);
}

Json number(const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
}

Json json_of(const Share& share) {
    const ConfidenceInterval confidence = share.confidence();
    Json json;
    json["count"] = share.count;
    json["of"] = share.total;
    json["share"] = number(share.value());
    json["confidence_95"] = {number(confidence.lowest), number(confidence.highest)};
    return json;
}

Json json_of(const Detection& detection) {
    Json json;
    json["warned"] = json_of(detection.warned);
    json["warned_100ms_before"] = json_of(detection.warned_100ms);
    json["false_alarms"] = json_of(detection.false_alarms);
    json["hard_false_alarms"] = json_of(detection.hard_false_alarms);
    json["alarms_between"] = json_of(detection.alarms_between);
    json["lead_time_median_s"] = number(quantile(detection.lead_times_s, 0.5));
    json["lead_time_10th_percentile_s"] = number(quantile(detection.lead_times_s, 0.1));
    return json;
}

Json json_of(double limit, const std::optional<CurvePoint>& point) {
    Json json;
    json["false_alarms_at_most"] = number(limit);
    if (!point) {
        json["threshold"] = nullptr;
        return json;
    }
    json["threshold"] = number(point->threshold);
    json["false_alarms"] = json_of(point->false_alarms);
    json["alarms_between"] = json_of(point->alarms_between);
    json["warned"] = json_of(point->warned);
    json["warned_100ms_before"] = json_of(point->warned_100ms);
    return json;
}

Json json_of(const RunGroup& group) {
    Json json;
    json["name"] = group.name;
    json["runs"] = group.runs;
    json["calm_runs"] = group.calm;
    json["runs_between"] = group.between;
    json["two_wheel_lift_offs"] = group.lifted;
    json["brief_two_wheel_lifts"] = group.brief_lifts;
    for (const Judgement& judgement : group.judgements) {
        Json one = json_of(judgement.detection);
        for (std::size_t i = 0U; i < judgement.best.size(); ++i) {
            one["best"].push_back(json_of(false_alarm_limits[i], judgement.best[i]));
        }
        json["indices"][judgement.name] = one;
    }
    return json;
}

Json json_of(const std::vector<RunGroup>& groups) {
    Json json = Json::array();
    for (const RunGroup& group : groups) {
        json.push_back(json_of(group));
    }
    return json;
}

std::string percent(const Share& share) {
    return share.total == 0U ? "-" : fmt::format("{:.2f}", 100.0 * share.value());
}

std::string percent_with_confidence(const Share& share) {
    const ConfidenceInterval confidence = share.confidence();
    return share.total == 0U ? "-"
                             : fmt::format("{:.2f} ({:.2f} to {:.2f})", 100.0 * share.value(),
                                           100.0 * confidence.lowest, 100.0 * confidence.highest);
}

std::string seconds(const std::optional<double>& time_s) {
    return time_s ? fmt::format("{:.3f}", *time_s) : "-";
}

std::string table_at_one(const RunGroup& group) {
    std::string text = fmt::format(
        "| | warned, % | 0.1 s before, % | median lead, s | 10th percentile, s | alarms in calm runs, % | "
        "of those from \\|LTR\\| {}, % | alarms in between, % |\n|---|---|---|---|---|---|---|---|\n",
        hard_ltr);
    for (const Judgement& judgement : group.judgements) {
        const Detection& detection = judgement.detection;
        text += fmt::format(
            "| {} | {} | {} | {} | {} | {} | {} | {} |\n", judgement.name,
            percent_with_confidence(detection.warned), percent_with_confidence(detection.warned_100ms),
            seconds(quantile(detection.lead_times_s, 0.5)), seconds(quantile(detection.lead_times_s, 0.1)),
            percent_with_confidence(detection.false_alarms), percent(detection.hard_false_alarms),
            percent(detection.alarms_between));
    }
    return text;
}

constexpr std::size_t one_percent = 2U;  // of false_alarm_limits

std::string table_of_best(const RunGroup& group) {
    std::string text =
        "| | threshold | alarms in calm runs, % | warned, % | 0.1 s before, % |\n|---|---|---|---|---|\n";
    for (const Judgement& judgement : group.judgements) {
        if (judgement.best.empty()) {
            continue;
        }
        const std::optional<CurvePoint>& best = judgement.best[one_percent];
        if (best) {
            text += fmt::format("| {} | {:.3f} | {} | {} | {} |\n", judgement.name, best->threshold,
                                percent(best->false_alarms), percent_with_confidence(best->warned),
                                percent_with_confidence(best->warned_100ms));
        } else {
            text += fmt::format("| {} | none | - | - | - |\n", judgement.name);
        }
    }
    return text;
}

std::string table_of_groups(const std::vector<RunGroup>& groups) {
    std::string text =
        "| | runs | calm | between | two wheels lift | brief lifts | warned, % | 0.1 s before, % | median "
        "lead, s "
        "| alarms in calm runs, % | alarms in between, % |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const RunGroup& group : groups) {
        const Detection& warning = group.judgements.front().detection;
        text +=
            fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", group.name, group.runs,
                        group.calm, group.between, group.lifted, group.brief_lifts, percent(warning.warned),
                        percent(warning.warned_100ms), seconds(quantile(warning.lead_times_s, 0.5)),
                        percent(warning.false_alarms), percent(warning.alarms_between));
    }
    return text;
}

}  // namespace

std::string report_json(const CampaignReport& report) {
    Json json;
    json["complete"] = report.all.runs >= report.runs_wanted;
    json["runs_wanted"] = report.runs_wanted;
    json["calm_below_ltr"] = calm_ltr;
    json["hard_from_ltr"] = hard_ltr;
    json["all"] = json_of(report.all);
    json["vehicles"] = json_of(report.vehicles);
    json["manoeuvres"] = json_of(report.manoeuvres);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_markdown(const CampaignReport& report) {
    const RunGroup& all = report.all;
    std::string text = "# Campaign\n\n";
    if (all.runs < report.runs_wanted) {
        text += fmt::format("**Not complete: {} of {} runs.**\n\n", all.runs, report.runs_wanted);
    }
    text += fmt::format(
        "{} runs: {} lift two wheels of one side for 50 ms or more, {} are calm (largest |LTR| below {}), {} "
        "lie between ({} of the last two kinds lift two wheels more briefly). In brackets: 95 % "
        "confidence.\n\n",
        all.runs, all.lifted, all.calm, calm_ltr, all.between, all.brief_lifts);
    text += "## The firmware's warning, and every index with its threshold at 1\n" + table_at_one(all);
    text += "\n## Every index with its threshold where at most 1 % of calm runs alarm\n" + table_of_best(all);
    text += "\n## The firmware's warning by vehicle\n" + table_of_groups(report.vehicles);
    text += "\n## The firmware's warning by manoeuvre\n" + table_of_groups(report.manoeuvres);
    return text;
}

}  // namespace sil
