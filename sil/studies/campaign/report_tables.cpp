#include "sil/studies/campaign/report_tables.hpp"

#include <fmt/format.h>

namespace sil {
namespace {

constexpr int of_words = TableColumn::of_words;

TableShare with_interval(const Share& share) {
    const ConfidenceInterval confidence = share.confidence();
    return {percent(share), 100.0 * confidence.lowest, 100.0 * confidence.highest};
}

void add_band_columns(Table& table) {
    for (const LoadBand band : load_bands) {
        table.columns.push_back({fmt::format("alarms {}", to_string(band)), 2, "%"});
    }
}

void add_alarms(std::vector<TableCell>& row, const Detection& detection) {
    for (const Share& share : detection.alarms) {
        row.emplace_back(percent(share));
    }
}

}  // namespace

Table table_of_judgements(const RunGroup& group) {
    Table table{"judgements",
                "The firmware's warning, and every index with its threshold at 1",
                {{"index", of_words, ""},
                 {"warned", 2, "%"},
                 {"0.1 s before", 2, "%"},
                 {"0.2 s before", 2, "%"},
                 {"median lead", 3, "s"},
                 {"10th percentile", 3, "s"},
                 {"alarms in calm runs", 2, "%"}},
                {},
                {}};
    add_band_columns(table);
    for (const Judgement& judgement : group.judgements) {
        const Detection& detection = judgement.detection;
        std::vector<TableCell> row{judgement.name,
                                   with_interval(detection.warned),
                                   with_interval(detection.warned_100ms),
                                   with_interval(detection.warned_200ms),
                                   detection.median_lead_s.value_or(not_known),
                                   detection.tenth_lead_s.value_or(not_known),
                                   with_interval(detection.false_alarms)};
        add_alarms(row, detection);
        table.rows.push_back(row);
    }
    return table;
}

Table table_of_best(const RunGroup& group, std::size_t first_limit, std::size_t last_limit) {
    Table table{"best",
                "Every index with the threshold that is best at a rate of alarms in calm runs",
                {{"index", of_words, ""},
                 {"alarms at most", 1, "%"},
                 {"threshold", 3, ""},
                 {"alarms in calm runs", 2, "%"},
                 {"warned", 2, "%"},
                 {"0.1 s before", 2, "%"},
                 {"0.2 s before", 2, "%"}},
                {},
                {}};
    add_band_columns(table);
    for (const Judgement& judgement : group.judgements) {
        for (std::size_t limit = first_limit; limit <= last_limit && limit < judgement.best.size(); ++limit) {
            const std::optional<BestThreshold>& best = judgement.best[limit];
            const Detection detection = best ? best->detection : Detection{};
            std::vector<TableCell> row{judgement.name,
                                       100.0 * false_alarm_limits[limit],
                                       best ? best->threshold : not_known,
                                       percent(detection.false_alarms),
                                       with_interval(detection.warned),
                                       with_interval(detection.warned_100ms),
                                       with_interval(detection.warned_200ms)};
            add_alarms(row, detection);
            table.rows.push_back(row);
        }
    }
    return table;
}

Table table_of_groups(const std::string& name, const std::string& key, const std::vector<RunGroup>& groups) {
    Table table{name,
                "",
                {{key, of_words, ""},
                 {"runs", 0, ""},
                 {"two wheels lift", 0, ""},
                 {"brief lifts", 0, ""},
                 {"not warned of", 0, "", true},
                 {"warned", 2, "%"},
                 {"0.1 s before", 2, "%"},
                 {"0.2 s before", 2, "%"},
                 {"median lead", 3, "s"},
                 {"alarms in calm runs", 2, "%", true},
                 {"wrong side", 2, "s"},
                 {"unavailable", 2, "s"},
                 {"runs with a code", 0, "", true}},
                {},
                {}};
    add_band_columns(table);
    for (const RunGroup& group : groups) {
        const Detection& warning = group.judgements.front().detection;
        std::vector<TableCell> row{group.name,
                                   group.runs,
                                   group.lifted,
                                   group.brief_lifts,
                                   warning.warned.total - warning.warned.count,
                                   percent(warning.warned),
                                   percent(warning.warned_100ms),
                                   percent(warning.warned_200ms),
                                   warning.median_lead_s.value_or(not_known),
                                   percent(warning.false_alarms),
                                   group.time.wrong_side_s,
                                   group.time.unavailable_s,
                                   group.time.coded_runs};
        add_alarms(row, warning);
        table.rows.push_back(row);
    }
    return table;
}

Table table_of_ordinary_driving(const TimeAccount& time) {
    const double hours = time.duration_s / hour_s;
    const double thousand_km = time.distance_m / thousand_km_m;
    Table table{"ordinary",
                "",
                {{"event", of_words, ""}, {"in all", 2, ""}, {"per hour", 3, ""}, {"per 1,000 km", 3, ""}},
                {},
                {}};
    const auto add = [&](const char* name, const auto value) {
        const auto number = static_cast<double>(value);
        table.rows.push_back({name, value, number / hours, number / thousand_km});
    };
    add("alarms", time.alarms);
    add("advisories", time.advisories);
    add("unavailable, s", time.unavailable_s);
    add("drives with a diagnostic code", time.coded_runs);
    return table;
}

std::string text_of_ordinary_driving(const CampaignReport& report) {
    const TimeAccount& time = report.ordinary;
    return fmt::format("{} drives, {:.1f} h, {:.0f} km; in no share above.", report.ordinary_runs,
                       time.duration_s / hour_s, time.distance_m / 1000.0);
}

std::string words_of_confidence(const RunGroup& group) {
    return group.vehicles < fewest_clusters ? "runs taken as independent, for there are few vehicles"
                                            : "counting vehicles, whose runs are not independent";
}

}  // namespace sil
