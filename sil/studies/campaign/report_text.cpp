// Report text: the judgements as JSON and as Markdown.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "sil/studies/campaign/report_tables.hpp"

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
    json["warned_200ms_before"] = json_of(detection.warned_200ms);
    json["false_alarms"] = json_of(detection.false_alarms);
    for (const LoadBand band : load_bands) {
        json["alarms"][to_string(band)] = json_of(detection.alarms[static_cast<std::size_t>(band)]);
    }
    json["lead_time_median_s"] = number(detection.median_lead_s);
    json["lead_time_10th_percentile_s"] = number(detection.tenth_lead_s);
    return json;
}

Json json_of(double limit, const std::optional<BestThreshold>& best) {
    Json json;
    json["false_alarms_at_most"] = number(limit);
    json["threshold"] = best ? number(best->threshold) : Json(nullptr);
    if (best) {
        Json detection = json_of(best->detection);
        detection.erase("lead_time_median_s");
        detection.erase("lead_time_10th_percentile_s");
        json.update(detection);
    }
    return json;
}

// Once there is any driving to count.
Json per(double count, double base) {
    return base > 0.0 ? number(count / base) : Json(nullptr);
}

Json json_of(const TimeAccount& time) {
    const double hours = time.duration_s / hour_s;
    const double thousand_km = time.distance_m / thousand_km_m;
    Json json;
    json["hours"] = number(hours);
    json["kilometres"] = number(time.distance_m / 1000.0);
    const auto add = [&](const char* name, double value) {
        json[name] = number(value);
        json[std::string{name} + "_per_hour"] = per(value, hours);
        json[std::string{name} + "_per_1000_km"] = per(value, thousand_km);
    };
    add("alarms", static_cast<double>(time.alarms));
    add("advisories", static_cast<double>(time.advisories));
    add("unavailable_s", time.unavailable_s);
    add("wrong_side_s", time.wrong_side_s);
    json["runs_with_diagnostic_code"] = time.coded_runs;
    return json;
}

Json json_of(const RunGroup& group) {
    Json json;
    json["name"] = group.name;
    json["runs"] = group.runs;
    json["vehicles"] = group.vehicles;
    json["calm_runs"] = group.calm;
    for (const LoadBand band : load_bands) {
        json["runs_by_load_transfer"][to_string(band)] = group.bands[static_cast<std::size_t>(band)];
    }
    json["two_wheel_lift_offs"] = group.lifted;
    json["brief_two_wheel_lifts"] = group.brief_lifts;
    json["wrong_side_s"] = number(group.time.wrong_side_s);
    json["wrong_side_s_per_1000_runs"] =
        per(1000.0 * group.time.wrong_side_s, static_cast<double>(group.runs));
    json["unavailable_s"] = number(group.time.unavailable_s);
    json["unavailable_s_per_1000_runs"] =
        per(1000.0 * group.time.unavailable_s, static_cast<double>(group.runs));
    json["runs_with_diagnostic_code"] = group.time.coded_runs;
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

constexpr std::size_t one_percent = 2U;  // of false_alarm_limits

// If there are more groups, only those with the fewest lift-offs warned of 0.1 s before.
constexpr std::size_t most_rows = 30U;

std::vector<RunGroup> worst_of(std::vector<RunGroup> groups) {
    const auto rank = [](const RunGroup& group) {
        const Share& share = group.judgements.front().detection.warned_100ms;
        return std::make_pair(share.total == 0U ? 2.0 : share.value(), std::string_view{group.name});
    };
    std::sort(groups.begin(), groups.end(),
              [&rank](const RunGroup& a, const RunGroup& b) { return rank(a) < rank(b); });
    groups.resize(most_rows);
    return groups;
}

std::string text_of_vehicles(const std::vector<RunGroup>& vehicles) {
    const bool all = vehicles.size() <= most_rows;
    return fmt::format("\n## The firmware's warning by vehicle{}\n{}",
                       all ? "" : fmt::format(": the worst {} of {}", most_rows, vehicles.size()),
                       markdown(table_of_groups("vehicles", "vehicle", all ? vehicles : worst_of(vehicles))));
}

std::string text_of_drawn_runs(const CampaignReport& report) {
    const RunGroup& all = report.all;
    std::string text = fmt::format(
        "{} runs of {} vehicles: {} lift two wheels of one side for 50 ms or more, {} do not; of these the "
        "largest |LTR| is",
        all.runs, all.vehicles, all.lifted, all.runs - all.lifted);
    for (const LoadBand band : load_bands) {
        text += fmt::format("{} {} in {}", band == load_bands[0] ? "" : ",", to_string(band),
                            all.bands[static_cast<std::size_t>(band)]);
    }
    text += fmt::format(
        " ({} lift two wheels more briefly). Calm: below 0.9. In brackets: 95 % confidence, {}.\n\n",
        all.brief_lifts, words_of_confidence(all));
    const double runs = static_cast<double>(all.runs);
    text += fmt::format(
        "The firmware's warning names the wrong side, beyond {} s after the swing, for {:.2f} s in all "
        "({:.2f} s in 1,000 runs); it is unavailable for {:.2f} s ({:.2f} s in 1,000 runs). Runs with a "
        "diagnostic code: {}.\n\n",
        WarningJudge::swing_s, all.time.wrong_side_s, 1000.0 * all.time.wrong_side_s / runs,
        all.time.unavailable_s, 1000.0 * all.time.unavailable_s / runs, all.time.coded_runs);
    text += "## The firmware's warning, and every index with its threshold at 1\n" +
            markdown(table_of_judgements(all));
    text += "\n## Every index with its threshold where at most 1 % of calm runs alarm\n" +
            markdown(table_of_best(all, one_percent, one_percent));
    text += text_of_vehicles(report.vehicles);
    if (!report.classes.empty()) {
        text += "\n## The firmware's warning by class of vehicle\n" +
                markdown(table_of_groups("classes", "class", report.classes));
    }
    text += "\n## The firmware's warning by manoeuvre\n" +
            markdown(table_of_groups("manoeuvres", "manoeuvre", report.manoeuvres));
    return text;
}

}  // namespace

std::string report_json(const CampaignReport& report) {
    Json json;
    json["complete"] = report.complete();
    json["runs_wanted"] = report.runs_wanted;
    json["confidence"] = report.all.vehicles < fewest_clusters ? "by run" : "by vehicle";
    json["all"] = json_of(report.all);
    json["vehicles"] = json_of(report.vehicles);
    json["classes"] = json_of(report.classes);
    json["manoeuvres"] = json_of(report.manoeuvres);
    json["ordinary_driving"] = report.ordinary_runs == 0U ? Json(nullptr) : json_of(report.ordinary);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_markdown(const CampaignReport& report) {
    std::string text = "# Campaign\n\n";
    if (!report.complete()) {
        text += fmt::format("**Not complete: {} of {} runs.**\n\n", report.all.runs + report.ordinary_runs,
                            report.runs_wanted);
    }
    if (report.all.runs > 0U) {
        text += text_of_drawn_runs(report);
    }
    if (report.ordinary_runs > 0U) {
        text += "\n## Ordinary driving\n" + text_of_ordinary_driving(report) + "\n\n" +
                markdown(table_of_ordinary_driving(report.ordinary));
    }
    return text;
}

}  // namespace sil
