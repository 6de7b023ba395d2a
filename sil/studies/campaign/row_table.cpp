// Row table: CSV to numbers, strictly.
#include "sil/studies/campaign/row_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

#include "sil/studies/campaign/settings.hpp"

namespace sil {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells{""};
    for (const char letter : line) {
        if (letter == ',') {
            cells.emplace_back();
        } else {
            cells.back() += letter;
        }
    }
    return cells;
}

class Line {
 public:
    Line(const std::vector<std::string>& names, const std::string& text, const std::string& place)
        : place_{place} {
        const std::vector<std::string> cells = split(text);
        if (cells.size() != names.size()) {
            throw CampaignError(fmt::format("{}: has {} cells, not {}", place, cells.size(), names.size()));
        }
        for (std::size_t i = 0U; i < names.size(); ++i) {
            cells_[names[i]] = cells[i];
        }
    }

    const std::string& text(const std::string& name) const {
        const auto cell = cells_.find(name);
        if (cell == cells_.end()) {
            throw CampaignError(fmt::format("{}: there is no column {}", place_, name));
        }
        return cell->second;
    }

    double number(const std::string& name) const {
        const std::string& cell = text(name);
        char* end = nullptr;
        const double value = std::strtod(cell.c_str(), &end);
        if (cell.empty() || *end != '\0' || !std::isfinite(value)) {
            throw CampaignError(fmt::format("{}: column {} wants a number, not \"{}\"", place_, name, cell));
        }
        return value;
    }

    std::optional<double> time(const std::string& name) const {
        return text(name).empty() ? std::nullopt : std::optional{number(name)};
    }

 private:
    std::string place_;
    std::map<std::string, std::string> cells_;
};

// Every column NAME_peak_100ms_before is of an index.
std::vector<std::string> index_names(const std::vector<std::string>& columns) {
    constexpr std::string_view ending = "_peak_100ms_before";
    std::vector<std::string> names;
    for (const std::string& column : columns) {
        if (column.size() > ending.size() &&
            column.compare(column.size() - ending.size(), ending.size(), ending) == 0) {
            names.push_back(column.substr(0U, column.size() - ending.size()));
        }
    }
    return names;
}

RecordedCampaignRun run_of(const Line& line, const std::vector<std::string>& names) {
    RecordedCampaignRun run;
    run.number = static_cast<std::uint64_t>(line.number("run"));
    run.vehicle = line.text("vehicle");
    run.manoeuvre = line.text("manoeuvre");
    run.largest_ltr = line.number("largest_ltr");
    run.two_wheel_lift_time_s = line.time("two_wheel_lift_time_s");
    run.brief_two_wheel_lift_time_s = line.time("brief_two_wheel_lift_time_s");
    run.warning_time_s = line.time("warning_time_s");
    for (const std::string& name : names) {
        run.indices.push_back({line.number(name + "_peak"), line.number(name + "_peak_100ms_before"),
                               line.time(name + "_time_s")});
    }
    return run;
}

}  // namespace

RowTable load_rows(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    std::string text;
    if (!file || !std::getline(file, text)) {
        throw CampaignError(fmt::format("{}: there are no rows; run the campaign first", path.string()));
    }
    const std::vector<std::string> columns = split(text);
    RowTable table;
    table.index_names = index_names(columns);
    // A line that the file ends without ending it was cut off.
    for (std::size_t number = 2U; std::getline(file, text) && !file.eof(); ++number) {
        table.runs.push_back(
            run_of(Line{columns, text, fmt::format("{}:{}", path.string(), number)}, table.index_names));
    }
    std::sort(table.runs.begin(), table.runs.end(),
              [](const auto& a, const auto& b) { return a.number < b.number; });
    return table;
}

}  // namespace sil
