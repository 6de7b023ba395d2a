#include "sil/studies/vehicle_validation/validation_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "sil/files/csv_writer.hpp"
#include "sil/page/study_page.hpp"
#include "sil/studies/drives/verdict.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double not_known = DriveSample::not_available;

// The quantity of this place, if the drive has it.
const ComparedQuantity* quantity_of(const DriveComparison& comparison, std::size_t place) {
    return place < comparison.quantities.size() ? &comparison.quantities[place] : nullptr;
}

double share_of(const DriveComparison& comparison, std::size_t place) {
    const ComparedQuantity* quantity = quantity_of(comparison, place);
    return quantity != nullptr ? quantity->share_within : not_known;
}

double rms_of(const DriveComparison& comparison, std::size_t place) {
    const ComparedQuantity* quantity = quantity_of(comparison, place);
    return quantity != nullptr ? quantity->rms_error : not_known;
}

// "2 outside, 3 within".
std::string counts(const Validation& validation) {
    std::map<std::string, int> verdicts;
    for (const DriveComparison& comparison : validation.comparisons) {
        ++verdicts[to_string(comparison.verdict)];
    }
    std::string text;
    for (const auto& [verdict, count] : verdicts) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict);
    }
    return text;
}

// The drives whose wheels and warnings do not fit together: "bank (false alarm)".
std::string wrongly_warned(const Validation& validation) {
    std::string names;
    for (std::size_t place = 0U; place < validation.replays.size(); ++place) {
        const std::string& verdict = validation.replays[place].verdict;
        for (const Verdict wrong :
             {Verdict::false_alarm, Verdict::wrong_side, Verdict::late, Verdict::missed}) {
            if (verdict == to_string(wrong)) {
                names += fmt::format("{}{} ({})", names.empty() ? "" : ", ",
                                     validation.comparisons[place].name, verdict);
            }
        }
    }
    return names;
}

std::string conclusion_on_roll(const Validation& validation, bool is_rightly_warned) {
    const auto any = [&validation](ComparisonVerdict verdict) {
        return std::any_of(validation.comparisons.begin(), validation.comparisons.end(),
                           [verdict](const DriveComparison& each) { return each.verdict == verdict; });
    };
    if (any(ComparisonVerdict::outside)) {
        return "The calibration does not describe every drive: see where the prediction leaves its corridor.";
    }
    if (!any(ComparisonVerdict::within)) {
        return "No drive says anything of the calibration.";
    }
    return is_rightly_warned ? "The calibration describes every drive that says anything of it."
                             : "The calibration describes the roll of every drive that says anything of it.";
}

std::string conclusion(const Validation& validation) {
    const std::string wrong = wrongly_warned(validation);
    const std::string of_roll = conclusion_on_roll(validation, wrong.empty());
    return wrong.empty() ? of_roll : fmt::format("{} The warning was wrong in: {}.", of_roll, wrong);
}

Table table_of_drives(const Validation& validation) {
    Table table;
    table.name = "drives";
    table.columns = {{"drive"},
                     {"comparison"},
                     {"roll angle within", 1, "%"},
                     {"error", 3, "deg rms"},
                     {"load transfer within", 1, "%"},
                     {"error", 4, "rms"},
                     {"up to", 2, "g"},
                     {"counted", 2, "s"},
                     {"replay"},
                     {"warnings"},
                     {"unavailable", 2, "s"},
                     {"confirmed codes"},
                     {"remark"}};
    for (std::size_t place = 0U; place < validation.comparisons.size(); ++place) {
        const DriveComparison& comparison = validation.comparisons[place];
        const ReplayRow& replay = validation.replays[place];
        table.rows.push_back({comparison.name, std::string{to_string(comparison.verdict)},
                              100.0 * share_of(comparison, 0U), rms_of(comparison, 0U),
                              100.0 * share_of(comparison, 1U), rms_of(comparison, 1U),
                              comparison.largest_force_mps2 / g_mps2, comparison.turn_s, replay.verdict,
                              replay.warnings.empty() ? std::string{"none"} : first_warnings(replay.warnings),
                              replay.unavailable_s.value_or(not_known),
                              replay.confirmed_codes.empty() ? std::string{"none"} : replay.confirmed_codes,
                              comparison.reason});
    }
    table.note = fmt::format(
        "Counted are turns of {:.1f} m/s^2 and more; with less than {:.1f} s of them a drive is too calm. "
        "Within: {:.0f} % "
        "of what is counted lies in the corridor about the measured signal: {} deg and {:.0f} % of the roll "
        "angle, {} and "
        "{:.0f} % of the load transfer ratio, {} s either way. These tolerances are this project's own.",
        least_turn_mps2, least_turn_s, 100.0 * least_share_within, roll_angle_tolerance_deg.offset,
        100.0 * roll_angle_tolerance_deg.share, load_transfer_tolerance.offset,
        100.0 * load_transfer_tolerance.share, roll_angle_tolerance_deg.time_s);
    return table;
}

StudyLine with_values(StudyLine line, const DriveComparison& comparison, const std::vector<double>& values) {
    for (std::size_t place = 0U; place < values.size(); place += chart_stride(values.size())) {
        line.points.push_back({comparison.time_s[place], values[place]});
    }
    return line;
}

StudyChart chart_of(const DriveComparison& comparison, const ComparedQuantity& quantity, std::size_t number) {
    StudyChart chart;
    chart.name = fmt::format("{}_{}", quantity.name, number);
    chart.heading = comparison.turn_s > 0.0
                        ? fmt::format("{}: {:.1f} % within", quantity.words, 100.0 * quantity.share_within)
                        : quantity.words;
    chart.x = {"time", "s", 2, {}, {}};
    chart.y = {quantity.words, quantity.unit, 3, {}, {}};
    StudyLine corridor =
        with_values(plain_line("corridor", "--quiet", 8.0), comparison, quantity.corridor.lower);
    corridor.style = StudyLine::Style::band;
    for (std::size_t point = 0U; point < corridor.points.size(); ++point) {
        corridor.points[point].push_back(
            quantity.corridor.upper[point * chart_stride(quantity.corridor.upper.size())]);
    }
    chart.lines = {corridor, with_values(measured_line("measured"), comparison, quantity.measured),
                   with_values(predicted_line("predicted"), comparison, quantity.predicted)};
    return chart;
}

}  // namespace

std::string validation_csv(const Validation& validation) {
    std::string text =
        "drive,comparison,roll_angle_within_share,roll_angle_rms_deg,load_transfer_within_share,load_"
        "transfer_rms,"
        "largest_force_mps2,turn_s,replay,warning_time_s,unavailable_duration_s,confirmed_codes,warnings,"
        "reason\n";
    for (std::size_t place = 0U; place < validation.comparisons.size(); ++place) {
        const DriveComparison& comparison = validation.comparisons[place];
        const ReplayRow& replay = validation.replays[place];
        CsvRow row;
        row.text(comparison.name).text(to_string(comparison.verdict));
        row.fixed(share_of(comparison, 0U), 4).fixed(rms_of(comparison, 0U), 4);
        row.fixed(share_of(comparison, 1U), 4).fixed(rms_of(comparison, 1U), 5);
        row.fixed(comparison.largest_force_mps2, 3).fixed(comparison.turn_s, 2).text(replay.verdict);
        row.fixed(replay.warning_s, 3).fixed(replay.unavailable_s, 3).text(replay.confirmed_codes);
        text += row.text(replay.warnings).text(comparison.reason).line() + "\n";
    }
    return text;
}

std::string validation_text(const Validation& validation) {
    std::string text;
    for (const std::string& warning : validation.warnings) {
        text += fmt::format("  identify doubts: {}\n", warning);
    }
    for (std::size_t place = 0U; place < validation.comparisons.size(); ++place) {
        const DriveComparison& comparison = validation.comparisons[place];
        const ReplayRow& replay = validation.replays[place];
        text += fmt::format("  {}: {}", comparison.name, to_string(comparison.verdict));
        for (const ComparedQuantity& quantity :
             comparison.turn_s > 0.0 ? comparison.quantities : std::vector<ComparedQuantity>{}) {
            text += fmt::format(", {} {:.1f} % within, error {:.3f} {}rms", quantity.words,
                                100.0 * quantity.share_within, quantity.rms_error,
                                quantity.unit.empty() ? "" : quantity.unit + " ");
        }
        text += fmt::format("{}; replay: {}{}\n", comparison.reason.empty() ? "" : "; " + comparison.reason,
                            replay.verdict,
                            replay.warnings.empty() ? "" : ", " + first_warnings(replay.warnings));
    }
    return text + fmt::format("{} drives: {}\n{}\n", validation.comparisons.size(), counts(validation),
                              conclusion(validation));
}

std::string validation_page(const Validation& validation) {
    StudyPage page{"Validation: " + validation.vehicle,
                   fmt::format("{} drives: {}", validation.comparisons.size(), counts(validation))};
    page.section("Result");
    page.text(fmt::format("{} {}", conclusion(validation), validation.calibration));
    page.table(table_of_drives(validation));
    if (!validation.warnings.empty()) {
        page.section("What to know about the calibration");
        page.list(validation.warnings);
    }
    for (std::size_t place = 0U; place < validation.comparisons.size(); ++place) {
        const DriveComparison& comparison = validation.comparisons[place];
        page.section(fmt::format("{}: {}", comparison.name, to_string(comparison.verdict)));
        if (!comparison.reason.empty()) {
            page.text(comparison.reason);
        }
        for (const ComparedQuantity& quantity : comparison.quantities) {
            page.chart(chart_of(comparison, quantity, place + 1U));
        }
    }
    return page.html();
}

}  // namespace sil
