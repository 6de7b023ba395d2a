#include "sil/studies/faults/search_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "page_templates.hpp"
#include "sil/page/table.hpp"
#include "sil/studies/faults/page_template.hpp"

namespace sil {
namespace {

constexpr std::size_t examples = 5U;

FoundClass& class_in(std::vector<FoundClass>& all, const FindingClass& found) {
    const auto held = std::find_if(all.begin(), all.end(),
                                   [&found](const FoundClass& each) { return each.found == found; });
    if (held != all.end()) {
        return *held;
    }
    all.push_back({found, {}});
    return all.back();
}

// The most frequent first; of equals the one with the earlier scenario.
bool is_before(const FoundClass& left, const FoundClass& right) {
    const auto key = [](const FoundClass& each) {
        return std::make_tuple(-static_cast<std::int64_t>(each.scenarios.size()), each.scenarios.front(),
                               each.found.kind);
    };
    return key(left) < key(right);
}

std::string numbers(const FoundClass& found) {
    const std::size_t count = std::min(examples, found.scenarios.size());
    return fmt::format("{}", fmt::join(found.scenarios.begin(),
                                       found.scenarios.begin() + static_cast<std::ptrdiff_t>(count), ", "));
}

double share_in_1000(std::size_t count, std::uint64_t all) {
    return all == 0U ? 0.0 : 1000.0 * static_cast<double>(count) / static_cast<double>(all);
}

}  // namespace

SearchReport report_on(const std::vector<SearchOutcome>& outcomes, std::uint64_t seed) {
    SearchReport report;
    report.seed = seed;
    report.scenarios = outcomes.size();
    for (const SearchOutcome& outcome : outcomes) {
        report.visible += outcome.visible ? 1U : 0U;
        report.told += outcome.told ? 1U : 0U;
        report.due += outcome.due ? 1U : 0U;
        for (const FindingKind kind : outcome.findings) {
            class_in(report.found, {kind, outcome.fault, outcome.place}).scenarios.push_back(outcome.number);
        }
    }
    std::sort(report.found.begin(), report.found.end(), is_before);
    return report;
}

std::vector<std::string> unknown_findings(const SearchReport& report) {
    std::vector<std::string> unknown;
    for (const FoundClass& each : report.found) {
        if (!is_known(each.found)) {
            unknown.push_back(fmt::format("{}: scenarios {}", describe(each.found), numbers(each)));
        }
    }
    return unknown;
}

std::vector<std::string> vanished_findings(const std::vector<SearchReport>& reports) {
    std::vector<std::string> vanished;
    for (const KnownFinding& known : known_findings()) {
        const bool found = std::any_of(reports.begin(), reports.end(), [&known](const SearchReport& report) {
            return std::any_of(report.found.begin(), report.found.end(),
                               [&known](const FoundClass& each) { return each.found == known.found; });
        });
        if (known.cells.empty() && !found) {
            vanished.push_back(describe(known.found));
        }
    }
    return vanished;
}

std::string search_section(const SearchReport& report) {
    std::size_t missed = 0U;
    std::size_t false_warnings = 0U;
    Table table;
    table.columns = {{"finding"}, {"fault"}, {"of"}, {"scenarios"}, {"the first of them"}};
    for (const FoundClass& each : report.found) {
        const bool misses = each.found.kind == FindingKind::missed_warning;
        (misses ? missed : false_warnings) += each.scenarios.size();
        table.rows.push_back({to_string(each.found.kind), to_string(each.found.fault),
                              to_string(each.found.place), each.scenarios.size(), numbers(each)});
    }
    return fmt::format(
        "### {} scenarios, seed {}\n"
        "In {} the fault was visible, {} were reported; in {} a warning was due. Missed warnings: {}, {:.1f} "
        "in 1,000 "
        "of the\ndue ones. False warnings: {}, {:.1f} in 1,000 scenarios.\n\n{}\n",
        report.scenarios, report.seed, report.visible, report.told, report.due, missed,
        share_in_1000(missed, report.due), false_warnings, share_in_1000(false_warnings, report.scenarios),
        markdown(table));
}

std::string search_document(const std::string& sections) {
    return fill_template(
        fault_search_template,
        {{"scenarios_a_drive", fmt::format("{}", FaultSearch::scenarios_a_drive)}, {"sections", sections}});
}

}  // namespace sil
