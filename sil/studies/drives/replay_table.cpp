#include "sil/studies/drives/replay_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>

#include "rsi/ecu/monitoring/diagnostic_code.hpp"
#include "sil/files/csv_writer.hpp"
#include "sil/studies/drives/verdict.hpp"

namespace sil {
namespace {

std::string number(const std::optional<double>& value, int decimals) {
    return value && std::isfinite(*value) ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

std::optional<double> time_of(const std::optional<EventMoment>& event) {
    return event ? std::optional<double>{event->time_s} : std::nullopt;
}

constexpr std::uint64_t wrong_roll_reference =
    std::uint64_t{1U} << static_cast<unsigned>(rsi::monitoring::DiagnosticCode::roll_angle_reference_wrong);

std::string advice(const std::vector<ReplayRow>& rows) {
    std::string drives;
    for (const ReplayRow& row : rows) {
        if (row.wrong_roll_reference) {
            drives += (drives.empty() ? "" : ", ") + row.drive;
        }
    }
    return drives.empty()
               ? std::string{}
               : fmt::format(
                     "{}: on banked road the roll angle is not what roll_angle_reference says. One against "
                     "the road lacks the bank, one against the horizon contains it: set the other of "
                     "\"road\" and \"horizon\" in the calibration, unless the accelerometer has an offset\n",
                     drives);
}

constexpr std::size_t shown_warnings = 4U;
constexpr const char* between_warnings = "; ";

}  // namespace

std::string all_warnings(const DriveReplay& replay) {
    std::string text;
    for (const ReplayWarning& warning : replay.warnings) {
        text += fmt::format("{}{} at {:.3f} s", text.empty() ? "" : between_warnings,
                            to_string(warning.named.side), warning.named.begin_s);
    }
    return text;
}

std::string first_warnings(const std::string& all) {
    std::size_t count = 0U, end = std::string::npos;
    for (std::size_t at = 0U; at < std::string::npos; ++count) {
        at = all.find(between_warnings, at == 0U ? 0U : at + 1U);
        end = count + 1U == shown_warnings ? at : end;
    }
    return count > shown_warnings ? fmt::format("{}; {} more", all.substr(0U, end), count - shown_warnings)
                                  : all;
}

ReplayRow replay_row(const std::string& file, const std::string& drive, const DriveReplay& replay) {
    const RunEvents& events = replay.events;
    ReplayRow row;
    row.file = file;
    row.drive = drive;
    row.warning_s = time_of(events.warning);
    row.one_wheel_lift_s = time_of(events.one_wheel_lift);
    row.two_wheel_lift_s = time_of(events.two_wheel_lift);
    row.lead_s = events.judgement.lead_s;
    row.wrong_side_s = events.judgement.wrong_side_s;
    row.unavailable_s = events.judgement.unavailable_s;
    row.confirmed_codes = code_names(replay.confirmed_codes);
    row.wrong_roll_reference = (replay.confirmed_codes & wrong_roll_reference) != 0U;
    row.largest_load_transfer_ratio = replay.largest_load_transfer_ratio;
    row.largest_warning_level = replay.largest_warning_level;
    row.verdict = to_string(verdict(replay));
    row.warnings = all_warnings(replay);
    return row;
}

ReplayRow failed_row(const std::string& file, const std::string& drive) {
    ReplayRow row;
    row.file = file;
    row.drive = drive;
    row.verdict = "failed";
    return row;
}

std::string table_csv(const std::vector<ReplayRow>& rows) {
    std::string text =
        "file,drive,warning_time_s,one_wheel_lift_time_s,two_wheel_lift_time_s,lead_time_s,"
        "wrong_side_duration_s,unavailable_duration_s,largest_load_transfer_ratio,largest_warning_level,"
        "verdict,confirmed_codes,warnings\n";
    for (const ReplayRow& row : rows) {
        CsvRow cells;
        cells.text(row.file).text(row.drive);
        for (const auto& time_s : {row.warning_s, row.one_wheel_lift_s, row.two_wheel_lift_s, row.lead_s,
                                   row.wrong_side_s, row.unavailable_s}) {
            cells.fixed(time_s, 3);
        }
        cells.fixed(row.largest_load_transfer_ratio, 4).fixed(row.largest_warning_level, 4);
        cells.text(row.verdict).text(row.confirmed_codes).text(row.warnings);
        text += cells.line() + "\n";
    }
    return text;
}

std::string table_text(const std::vector<ReplayRow>& rows) {
    std::size_t width = 5U;
    std::map<std::string, int> counts;
    for (const ReplayRow& row : rows) {
        width = std::max(width, row.drive.size());
        ++counts[row.verdict];
    }
    std::string text = fmt::format("{:<{}}  {:>9}  {:>9}  {:>10}  {:>8}  {:>7}  {:>7}  {:>7}  {:>7}  {}\n",
                                   "drive", width, "warning s", "1 wheel s", "2 wheels s", "lead s",
                                   "wrong s", "none s", "|LTR|", "level", "verdict");
    for (const ReplayRow& row : rows) {
        fmt::format_to(std::back_inserter(text),
                       "{:<{}}  {:>9}  {:>9}  {:>10}  {:>8}  {:>7}  {:>7}  {:>7}  {:>7}  {}{}{}\n", row.drive,
                       width, number(row.warning_s, 2), number(row.one_wheel_lift_s, 2),
                       number(row.two_wheel_lift_s, 2), number(row.lead_s, 2), number(row.wrong_side_s, 2),
                       number(row.unavailable_s, 2), number(row.largest_load_transfer_ratio, 3),
                       number(row.largest_warning_level, 3), row.verdict,
                       row.warnings.empty() ? "" : ": " + first_warnings(row.warnings),
                       row.confirmed_codes.empty() ? "" : " (" + row.confirmed_codes + ")");
    }
    text += fmt::format("{} drives:", rows.size());
    const char* separator = " ";
    for (const auto& [verdict, count] : counts) {
        fmt::format_to(std::back_inserter(text), "{}{} {}", separator, count, verdict);
        separator = ", ";
    }
    return text + "\n" + advice(rows);
}

}  // namespace sil
