// The rows of a fault search.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "sil/files/csv_reader.hpp"
#include "sil/files/file_io.hpp"
#include "sil/studies/campaign/campaign_folder.hpp"
#include "sil/studies/faults/fault_search.hpp"

namespace sil {
namespace {

constexpr const char* header = "scenario,fault,of,visible,due,told,missed_warning,false_warning";
constexpr std::size_t columns_of_search = 8U;

bool has(const SearchOutcome& outcome, FindingKind kind) {
    return std::find(outcome.findings.begin(), outcome.findings.end(), kind) != outcome.findings.end();
}

std::string row_of(const SearchOutcome& outcome) {
    return fmt::format("{},{},{},{:d},{:d},{:d},{:d},{:d}", outcome.number, to_string(outcome.fault),
                       to_string(outcome.place), outcome.visible, outcome.due, outcome.told,
                       has(outcome, FindingKind::missed_warning), has(outcome, FindingKind::false_warning));
}

template <typename Value>
Value value_named(std::string_view name, Value last) {
    for (std::size_t value = 0U; value < static_cast<std::size_t>(last); ++value) {
        if (name == to_string(static_cast<Value>(value))) {
            return static_cast<Value>(value);
        }
    }
    return last;
}

SearchOutcome outcome_of(const std::vector<CsvField>& cells) {
    const auto is = [&cells](std::size_t column) { return cells[column].text == "1"; };
    SearchOutcome outcome{static_cast<std::uint64_t>(finite_number(cells[0].text).value_or(0.0)),
                          value_named(cells[1].text, FaultKind::turned_about_z),
                          value_named(cells[2].text, FaultPlace::all_signals),
                          is(3U),
                          is(4U),
                          is(5U),
                          {}};
    if (is(6U)) {
        outcome.findings.push_back(FindingKind::missed_warning);
    }
    if (is(7U)) {
        outcome.findings.push_back(FindingKind::false_warning);
    }
    return outcome;
}

}  // namespace

RowProgress run_fault_search(const FaultSearch& search, const std::filesystem::path& output, unsigned jobs,
                             const std::atomic<bool>& stop, const RowListener& listener) {
    const CampaignFolder folder{output, search.settings()};
    RowFile file{folder.rows(), header};
    const auto make = [&search](std::uint64_t number) { return MadeRow{row_of(search.run(number))}; };
    return make_rows(file, {search.settings().runs, jobs, make}, stop, listener);
}

std::vector<SearchOutcome> load_search(const std::filesystem::path& output) {
    const std::string text = read_whole_file(output / "runs.csv");
    CsvLines lines{text};
    CsvLine line;
    lines.next(line);
    std::vector<CsvField> cells;
    std::vector<SearchOutcome> all;
    while (lines.next(line)) {
        split_fields(line.text, cells);
        if (cells.size() == columns_of_search) {
            all.push_back(outcome_of(cells));
        }
    }
    return all;
}

}  // namespace sil
