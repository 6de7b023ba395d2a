// Report files: curves and lead times as CSV, and what the pictures need to know besides.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sil/files/csv_writer.hpp"
#include "sil/files/file_io.hpp"
#include "sil/studies/campaign/report.hpp"

namespace sil {
namespace {

std::string curve_lines(const std::string& name, const std::vector<CurvePoint>& curve) {
    std::string text;
    for (const CurvePoint& point : distinct_points(curve)) {
        CsvRow row;
        row.text(name).number(point.threshold, 6).fixed(point.false_alarms.value(), 6);
        for (const Share& share : point.alarms) {
            row.fixed(share.value(), 6);
        }
        for (const Share& share : {point.warned, point.warned_100ms, point.warned_200ms}) {
            row.fixed(share.value(), 6);
        }
        text += row.line() + "\n";
    }
    return text;
}

std::string curves_csv(const CampaignReport& report) {
    std::string text =
        "index,threshold,false_alarm_share,alarm_share_below_0.7,alarm_share_from_0.7,alarm_share_from_0.8,"
        "alarm_share_from_0.9,warned_share,warned_100ms_share,warned_200ms_share\n";
    for (std::size_t i = 0U; i < report.curves.size(); ++i) {
        text += curve_lines(report.all.judgements[i + 1U].name, report.curves[i]);
    }
    return text;
}

std::string leads_csv(const CampaignReport& report) {
    std::string text = "index,lead_time_s,share_with_at_least\n";
    for (const Judgement& judgement : report.all.judgements) {
        for (const LeadShare& each : lead_shares(judgement, report.all.lifted)) {
            text += CsvRow{}.text(judgement.name).fixed(each.lead_s, 3).fixed(each.share, 6).line() + "\n";
        }
    }
    return text;
}

std::string picture_settings(const CampaignReport& report) {
    std::string names;
    for (std::size_t i = 1U; i < report.all.judgements.size(); ++i) {
        names += (i == 1U ? "" : " ") + report.all.judgements[i].name;
    }
    const Detection& warning = report.all.judgements.front().detection;
    const auto number = [](double value) {
        return std::isfinite(value) ? fmt::format("{:.6f}", value) : "NaN";
    };
    return fmt::format(
        "# What the pictures of a campaign need besides curves.csv and leads.csv.\n"
        "index_names = \"{}\"\nwarning_false_alarm_share = {}\nwarning_warned_share = {}\n"
        "warning_warned_100ms_share = {}\nwarning_warned_200ms_share = {}\nruns = {}\nlifted_runs = "
        "{}\ncalm_runs = {}\n",
        names, number(warning.false_alarms.value()), number(warning.warned.value()),
        number(warning.warned_100ms.value()), number(warning.warned_200ms.value()), report.all.runs,
        report.all.lifted, report.all.calm);
}

}  // namespace

std::vector<CurvePoint> distinct_points(const std::vector<CurvePoint>& curve) {
    const auto place = [](const CurvePoint& point) {
        constexpr double steps = 5000.0;
        return std::make_tuple(
            std::lround(steps * point.false_alarms.value()), std::lround(steps * point.warned.value()),
            std::lround(steps * point.warned_100ms.value()), std::lround(steps * point.warned_200ms.value()));
    };
    std::vector<CurvePoint> points;
    for (std::size_t i = 0U; i < curve.size(); ++i) {
        if (i == 0U || i + 1U == curve.size() || place(curve[i]) != place(curve[i - 1U])) {
            points.push_back(curve[i]);
        }
    }
    return points;
}

std::vector<LeadShare> lead_shares(const Judgement& judgement, std::size_t lifted) {
    std::vector<double> leads_s = judgement.detection.lead_times_s;
    std::sort(leads_s.begin(), leads_s.end(), std::greater<>{});
    leads_s.erase(std::find(leads_s.begin(), leads_s.end(), 0.0), leads_s.end());
    std::vector<LeadShare> shares;
    for (std::size_t i = 0U; i < leads_s.size(); ++i) {
        shares.push_back({leads_s[i], static_cast<double>(i + 1U) / static_cast<double>(lifted)});
    }
    return shares;
}

void write_report(const CampaignReport& report, const std::filesystem::path& folder) {
    write_file_atomically(folder / "curves.csv", curves_csv(report));
    write_file_atomically(folder / "leads.csv", leads_csv(report));
    write_file_atomically(folder / "report.gp", picture_settings(report));
    write_file_atomically(folder / "report.md", report_markdown(report));
    write_file_atomically(folder / "report.json", report_json(report));
}

}  // namespace sil
