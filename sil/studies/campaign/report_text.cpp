// Report text: the judgements as JSON and as Markdown.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

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

constexpr double hour_s = 3600.0;
constexpr double thousand_km_m = 1.0e6;

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

std::string alarms_of(const Detection& detection, std::string (*text_of)(const Share&)) {
    std::string cells;
    for (const Share& share : detection.alarms) {
        cells += " | " + text_of(share);
    }
    return cells;
}

// " | 0.7 to 0.8 | ..."
std::string band_names() {
    std::string cells;
    for (const LoadBand band : load_bands) {
        cells += fmt::format(" | {}", to_string(band));
    }
    return cells;
}

std::string rule(int columns) {
    std::string text = "|";
    for (int column = 0; column < columns; ++column) {
        text += "---|";
    }
    return text + "\n";
}

std::string table_at_one(const RunGroup& group) {
    std::string text = fmt::format(
        "| | warned, % | 0.1 s before, % | 0.2 s before, % | median lead, s | 10th percentile, s | alarms in "
        "calm runs, %{} |\n",
        band_names());
    text += rule(11);
    for (const Judgement& judgement : group.judgements) {
        const Detection& detection = judgement.detection;
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {}{} |\n", judgement.name,
                            percent_with_confidence(detection.warned),
                            percent_with_confidence(detection.warned_100ms),
                            percent_with_confidence(detection.warned_200ms), seconds(detection.median_lead_s),
                            seconds(detection.tenth_lead_s), percent_with_confidence(detection.false_alarms),
                            alarms_of(detection, percent));
    }
    return text;
}

constexpr std::size_t one_percent = 2U;  // of false_alarm_limits

std::string table_of_best(const RunGroup& group) {
    std::string text = fmt::format(
        "| | threshold | alarms in calm runs, %{} | warned, % | 0.1 s before, % | 0.2 s before, % |\n",
        band_names());
    text += rule(10);
    for (const Judgement& judgement : group.judgements) {
        if (judgement.best.empty()) {
            continue;
        }
        const std::optional<BestThreshold>& best = judgement.best[one_percent];
        if (best) {
            const Detection& detection = best->detection;
            text += fmt::format("| {} | {:.3f} | {}{} | {} | {} | {} |\n", judgement.name, best->threshold,
                                percent(detection.false_alarms), alarms_of(detection, percent),
                                percent_with_confidence(detection.warned),
                                percent_with_confidence(detection.warned_100ms),
                                percent_with_confidence(detection.warned_200ms));
        } else {
            text += fmt::format("| {} | none | - | - | - | - | - | - | - | - |\n", judgement.name);
        }
    }
    return text;
}

std::string table_of_groups(const std::vector<RunGroup>& groups) {
    std::string text = fmt::format(
        "| | runs | two wheels lift | brief lifts | warned, % | 0.1 s before, % | 0.2 s before, % | median "
        "lead, s{} | wrong side, s | unavailable, s |\n",
        band_names());
    text += rule(14);
    for (const RunGroup& group : groups) {
        const Detection& warning = group.judgements.front().detection;
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {}{} | {:.2f} | {:.2f} |\n", group.name,
                            group.runs, group.lifted, group.brief_lifts, percent(warning.warned),
                            percent(warning.warned_100ms), percent(warning.warned_200ms),
                            seconds(warning.median_lead_s), alarms_of(warning, percent),
                            group.time.wrong_side_s, group.time.unavailable_s);
    }
    return text;
}

// Of so many that nobody would read the table those with the fewest lift-offs warned of 0.1 s before.
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
    if (vehicles.size() <= most_rows) {
        return "\n## The firmware's warning by vehicle\n" + table_of_groups(vehicles);
    }
    return fmt::format("\n## The firmware's warning by vehicle: the worst {} of {}\n{}", most_rows,
                       vehicles.size(), table_of_groups(worst_of(vehicles)));
}

std::string text_of_ordinary_driving(const CampaignReport& report) {
    if (report.ordinary_runs == 0U) {
        return {};
    }
    const TimeAccount& time = report.ordinary;
    const double hours = time.duration_s / hour_s;
    const double thousand_km = time.distance_m / thousand_km_m;
    std::string text = fmt::format(
        "\n## Ordinary driving\n{} drives, {:.1f} h, {:.0f} km.\n\n| | in all | per hour | per 1,000 km |\n",
        report.ordinary_runs, hours, time.distance_m / 1000.0);
    text += rule(4);
    const auto row = [&](const char* name, double value, int decimals) {
        text += fmt::format("| {} | {:.{}f} | {:.3f} | {:.3f} |\n", name, value, decimals, value / hours,
                            value / thousand_km);
    };
    row("alarms", static_cast<double>(time.alarms), 0);
    row("advisories", static_cast<double>(time.advisories), 0);
    row("unavailable, s", time.unavailable_s, 2);
    row("drives with a diagnostic code", static_cast<double>(time.coded_runs), 0);
    return text;
}

// Of what the intervals are made.
const char* words_of_confidence(const RunGroup& group) {
    return group.vehicles < fewest_clusters ? "runs taken as independent, for there are few vehicles"
                                            : "counting vehicles, whose runs are not independent";
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
    text += "## The firmware's warning, and every index with its threshold at 1\n" + table_at_one(all);
    text += "\n## Every index with its threshold where at most 1 % of calm runs alarm\n" + table_of_best(all);
    text += text_of_vehicles(report.vehicles);
    if (!report.classes.empty()) {
        text += "\n## The firmware's warning by class of vehicle\n" + table_of_groups(report.classes);
    }
    text += "\n## The firmware's warning by manoeuvre\n" + table_of_groups(report.manoeuvres);
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
    return text + text_of_ordinary_driving(report);
}

}  // namespace sil
