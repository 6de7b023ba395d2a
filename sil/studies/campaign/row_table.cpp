// Row table: CSV to numbers, strictly.
#include "sil/studies/campaign/row_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "sil/files/csv_reader.hpp"
#include "sil/files/whole_file.hpp"
#include "sil/input_error.hpp"
#include "sil/printable.hpp"

namespace sil {
namespace {

constexpr const char* remedy = "do the campaign again, or take the folder of one that this program made";

// One row, whose cells are found by the names of their columns.
class Row {
 public:
    Row(const CsvPlace& place, const std::vector<std::string>& columns, const CsvLine& line)
        : place_{place}, columns_{columns}, number_{line.number} {
        split_fields(line.text, cells_);
        if (cells_.size() != columns.size()) {
            place.fail(number_, 1U, fmt::format("has {} cells, not {}", cells_.size(), columns.size()),
                       remedy);
        }
    }

    std::string text(std::string_view name) const { return std::string{cell(name).text}; }

    double number(std::string_view name) const {
        const CsvField& field = cell(name);
        const std::optional<double> value = finite_number(field.text);
        if (!value) {
            place_.fail(number_, field.column,
                        fmt::format("column {} wants a number, not \"{}\"", name, printable(field.text)),
                        remedy);
        }
        return *value;
    }

    std::optional<double> time(std::string_view name) const {
        return cell(name).text.empty() ? std::nullopt : std::optional{number(name)};
    }

 private:
    const CsvField& cell(std::string_view name) const {
        const auto column = std::find(columns_.begin(), columns_.end(), name);
        if (column == columns_.end()) {
            place_.fail(1U, 1U, fmt::format("there is no column {}", name), remedy);
        }
        return cells_[static_cast<std::size_t>(column - columns_.begin())];
    }

    const CsvPlace& place_;
    const std::vector<std::string>& columns_;
    std::size_t number_;
    std::vector<CsvField> cells_{};
};

// Every column NAME_threshold_100ms is of an index.
std::vector<std::string> index_names(const std::vector<std::string>& columns) {
    constexpr std::string_view ending = "_threshold_100ms";
    std::vector<std::string> names;
    for (const std::string& column : columns) {
        if (column.size() > ending.size() &&
            column.compare(column.size() - ending.size(), ending.size(), ending) == 0) {
            names.push_back(column.substr(0U, column.size() - ending.size()));
        }
    }
    return names;
}

RecordedCampaignRun run_of(const Row& row, const std::vector<std::string>& names) {
    RecordedCampaignRun run;
    run.number = static_cast<std::uint64_t>(row.number("run"));
    run.vehicle = row.text("vehicle");
    run.in_class = row.text("class");
    run.manoeuvre = row.text("manoeuvre");
    run.largest_ltr = row.number("largest_ltr");
    run.two_wheel_lift_time_s = row.time("two_wheel_lift_time_s");
    run.brief_two_wheel_lift_time_s = row.time("brief_two_wheel_lift_time_s");
    run.end_time_s = row.number("end_time_s");
    run.distance_m = row.number("distance_m");
    run.lead_s = row.time("lead_time_s");
    run.wrong_side_s = row.number("wrong_side_duration_s");
    run.warnings = static_cast<unsigned>(row.number("warnings"));
    run.advisories = static_cast<unsigned>(row.number("advisories"));
    run.unavailable_s = row.number("unavailable_duration_s");
    run.has_code = !row.text("diagnostic_codes").empty();
    for (const std::string& name : names) {
        run.indices.push_back({row.number(name + "_threshold"), row.number(name + "_threshold_100ms"),
                               row.number(name + "_threshold_200ms"), row.time(name + "_lead_time_s")});
    }
    return run;
}

}  // namespace

RowTable load_rows(const std::filesystem::path& path) {
    const std::string text = std::filesystem::exists(path) ? read_whole_file(path) : std::string{};
    CsvLines lines{text};
    CsvLine line;
    if (!lines.next(line)) {
        throw InputError(fmt::format("{}: there are no rows; run the campaign first", path.string()));
    }
    std::vector<CsvField> names;
    split_fields(line.text, names);
    std::vector<std::string> columns;
    for (const CsvField& name : names) {
        columns.emplace_back(name.text);
    }
    const CsvPlace place{path.string()};
    RowTable table;
    table.index_names = index_names(columns);
    // A line that the file ends without ending it was cut off.
    while (lines.next(line) && line.is_ended) {
        table.runs.push_back(run_of(Row{place, columns, line}, table.index_names));
    }
    std::sort(table.runs.begin(), table.runs.end(),
              [](const auto& a, const auto& b) { return a.number < b.number; });
    return table;
}

}  // namespace sil
