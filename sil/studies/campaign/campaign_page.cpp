#include "sil/studies/campaign/campaign_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>

#include "sil/page/study_page.hpp"
#include "sil/results/versions.hpp"
#include "sil/studies/campaign/report_tables.hpp"
#include "sil/world/manoeuvres/mixed_driving.hpp"

namespace sil {
namespace {

constexpr std::size_t most_listed_runs = 500U;

double or_not_known(const std::optional<double>& value) {
    return value.value_or(not_known);
}

// The firmware's warning is no index with a threshold: it comes first, in a colour of its own.
StudyLine line_of_warning(StudyLine::Style style) {
    StudyLine line;
    line.words = "warning";
    line.colour = "--ink";
    line.width = 3.5;
    line.style = style;
    return line;
}

StudyChart chart_of_leads(const CampaignReport& report) {
    StudyChart chart;
    chart.name = "leads";
    chart.heading = "Lift-offs warned of at least so early, every threshold at 1";
    chart.x = {"lead", "s", 3, 0.0, 1.5};
    chart.y = {"lift-offs with at least this lead", "%", 2, 0.0, 100.0};
    chart.marks_x = {early_s, very_early_s};
    chart.reading = StudyReading::next;
    for (std::size_t place = 0U; place < report.all.judgements.size(); ++place) {
        const Judgement& judgement = report.all.judgements[place];
        StudyLine line = place == 0U ? line_of_warning(StudyLine::Style::line) : index_line(judgement.name);
        for (const LeadShare& share : lead_shares(judgement, report.all.lifted)) {
            if (!line.points.empty() && line.points.back()[0] == share.lead_s) {
                line.points.pop_back();  // all of them have at least this lead
            }
            line.points.push_back({share.lead_s, 100.0 * share.share});
        }
        std::reverse(line.points.begin(), line.points.end());
        chart.lines.push_back(line);
    }
    return chart;
}

StudyChart chart_of_detection(const CampaignReport& report, const std::string& name,
                              const std::string& heading, Share CurvePoint::* of_index,
                              Share Detection::* of_warning) {
    StudyChart chart;
    chart.name = name;
    chart.heading = heading;
    chart.x = {"alarms in calm runs", "%", 2, 0.0, 5.0};
    chart.y = {"two-wheel lift-offs warned of", "%", 2, {}, 100.0};
    chart.note = "Read off is the most that so many alarms give; in brackets the threshold for it.";
    chart.reading = StudyReading::last;
    const Detection& warning = report.all.judgements.front().detection;
    StudyLine point = line_of_warning(StudyLine::Style::mark);
    if (warning.false_alarms.total > 0U && (warning.*of_warning).total > 0U) {
        point.points.push_back({percent(warning.false_alarms), percent(warning.*of_warning)});
        chart.x.to = std::max(*chart.x.to, std::ceil(1.05 * percent(warning.false_alarms)));
    }
    chart.lines.push_back(point);
    for (std::size_t index = 0U; index < report.curves.size(); ++index) {
        StudyLine line = index_line(report.all.judgements[index + 1U].name);
        for (const CurvePoint& each : distinct_points(report.curves[index])) {
            line.points.push_back({percent(each.false_alarms), percent(each.*of_index), each.threshold});
        }
        chart.lines.push_back(line);
    }
    return chart;
}

// In a shell's single quotes only the quote itself is special.
std::string quoted(const std::string& text) {
    constexpr const char* harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+:@%-";
    if (!text.empty() && text.front() != '-' && text.find_first_not_of(harmless) == std::string::npos) {
        return text;
    }
    std::string result = "'";
    for (const char character : text) {
        result += character == '\'' ? std::string{"'\\''"} : std::string(1U, character);
    }
    return result + "'";
}

// Which runs, each with the command that drives it again.
Table table_of_runs(const std::string& name, const std::string& heading, const RowTable& rows,
                    const CampaignCall& call,
                    const std::function<bool(const RecordedCampaignRun&)>& is_listed) {
    Table table{name,
                heading,
                {{"run", 0, ""},
                 {"vehicle", TableColumn::of_words, ""},
                 {"manoeuvre", TableColumn::of_words, ""},
                 {"two wheels lift", 3, "s"},
                 {"lead", 3, "s"},
                 {"largest |LTR|", 3, ""},
                 {"warnings", 0, ""},
                 {"drives it again, and leaves its report.html", TableColumn::of_words, ""}},
                {},
                {}};
    std::size_t found = 0U;
    for (const RecordedCampaignRun& run : rows.runs) {
        if (!is_listed(run) || ++found > most_listed_runs) {
            continue;
        }
        table.rows.push_back(
            {run.number, run.vehicle.text(), run.manoeuvre.text(), or_not_known(run.two_wheel_lift_time_s),
             or_not_known(run.lead_s), run.largest_ltr, run.warnings,
             fmt::format("(cd {} && {} campaign one {} --settings {} --output {})",
                         quoted(call.working_folder.string()), quoted(call.program.string()), run.number,
                         quoted((call.output / "campaign.toml").string()), quoted(call.output.string()))});
    }
    table.note = found > most_listed_runs
                     ? fmt::format("The first {} of {}; the rows have all.", most_listed_runs, found)
                     : (found == 0U ? "There are none." : "");
    return table;
}

void add_shares(StudyPage& page, const CampaignReport& report) {
    const RunGroup& all = report.all;
    page.section("The warning");
    page.text(
        fmt::format("{} of {} runs lift two wheels of a side. The shares belong to this mixture of drives; "
                    "intervals are of 95 %, {}.",
                    all.lifted, all.runs, words_of_confidence(all)));
    page.chart(chart_of_leads(report));
    page.chart(chart_of_detection(report, "detection", "In force with the right side as two wheels lift",
                                  &CurvePoint::warned, &Detection::warned));
    page.chart(chart_of_detection(report, "detection_100ms", "For 0.1 s or more", &CurvePoint::warned_100ms,
                                  &Detection::warned_100ms));
    page.chart(chart_of_detection(report, "detection_200ms", "For 0.2 s or more", &CurvePoint::warned_200ms,
                                  &Detection::warned_200ms));
    page.table(table_of_judgements(all));
    page.table(table_of_best(all, 0U, std::size(false_alarm_limits) - 1U));
    page.section("By manoeuvre");
    page.table(table_of_groups("manoeuvres", "manoeuvre", report.manoeuvres));
    if (!report.classes.empty()) {
        page.section("By class of vehicle");
        page.table(table_of_groups("classes", "class", report.classes));
    }
    page.section("By vehicle");
    page.table(table_of_groups("vehicles", "vehicle", report.vehicles));
}

void add_ordinary(StudyPage& page, const CampaignReport& report) {
    page.section("Ordinary driving");
    page.text(text_of_ordinary_driving(report));
    page.table(table_of_ordinary_driving(report.ordinary));
}

}  // namespace

std::string campaign_page(const CampaignReport& report, const RowTable& table, const CampaignCall& call) {
    const Versions versions = built_versions();
    StudyPage page{
        "Campaign",
        fmt::format("{} runs{}; component {} {}", report.all.runs + report.ordinary_runs,
                    report.complete() ? "" : fmt::format(" of {}: not complete", report.runs_wanted),
                    versions.component, versions.git_revision)};
    if (report.all.runs > 0U) {
        add_shares(page, report);
    }
    if (report.ordinary_runs > 0U) {
        add_ordinary(page, report);
    }
    page.section("Runs to look into");
    page.table(table_of_runs("missed", "Two wheels lift, without a warning of the right side in force", table,
                             call, [](const RecordedCampaignRun& run) {
                                 return run.manoeuvre != ordinary_driving_name && is_lifted(run) &&
                                        !is_warned(run.lead_s);
                             }));
    page.table(
        table_of_runs("false_alarms", "Alarms in calm runs", table, call, [](const RecordedCampaignRun& run) {
            return run.manoeuvre != ordinary_driving_name && !is_lifted(run) && is_calm(run) &&
                   run.warnings > 0U;
        }));
    return page.html();
}

}  // namespace sil
