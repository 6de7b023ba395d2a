// The intermittent faults as a page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "page_templates.hpp"
#include "sil/studies/faults/intermittent.hpp"
#include "sil/studies/faults/page_template.hpp"

namespace sil {
namespace {

struct Summary {
    std::size_t runs{0U};
    std::size_t repeating{0U};
    std::size_t with_code{0U};  // of these
    int latest_code_ms{0};      // of these, from the beginning of the third burst on
    int false_warning_ms{0};    // the longest in a run
    int without_code_ms{0};     // likewise
};

std::string name_of(const Fault& fault) {
    return fmt::format("{} | {}", to_string(fault.place),
                       describe_each_sign({fault.kind, fault.place, std::abs(fault.magnitude)}));
}

void add(Summary& all, const IntermittentRun& run) {
    ++all.runs;
    all.false_warning_ms = std::max(all.false_warning_ms, run.false_warning_ms);
    all.without_code_ms = std::max(all.without_code_ms, run.without_code_ms);
    if (run.period_ms > 0) {
        ++all.repeating;
        all.with_code += run.code_ms ? 1U : 0U;
        all.latest_code_ms = std::max(all.latest_code_ms, run.code_ms.value_or(0));
    }
}

std::string row(const std::string& name, const Summary& all) {
    const std::string latest = all.with_code > 0U ? fmt::format("{}", all.latest_code_ms) : "";
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", name, all.runs, all.repeating, all.with_code,
                       latest, all.false_warning_ms, all.without_code_ms);
}

}  // namespace

std::string intermittent_row(const std::string& name, const std::vector<IntermittentRun>& runs) {
    Summary all;
    for (const IntermittentRun& run : runs) {
        add(all, run);
    }
    return row(name, all);
}

std::string intermittent_document(const std::vector<IntermittentRun>& runs, const std::string& sums) {
    std::vector<std::pair<std::string, Summary>> rows;  // in the order of the runs
    for (const IntermittentRun& run : runs) {
        const std::string name = name_of(run.fault);
        const auto held =
            std::find_if(rows.begin(), rows.end(), [&name](const auto& each) { return each.first == name; });
        add(held == rows.end() ? rows.emplace_back(name, Summary{}).second : held->second, run);
    }
    std::string table;
    for (const auto& [name, all] : rows) {
        table += row(name, all);
    }
    return fill_template(intermittent_faults_template, {{"table", table}, {"sums", sums}});
}

std::vector<std::string> intermittent_shortfalls(const std::vector<IntermittentRun>& runs) {
    std::vector<std::string> found;
    for (const IntermittentRun& run : runs) {
        if (run.without_code_ms > longest_unreported_ms) {
            found.push_back(
                fmt::format("{}, {}: {} of {} for {} ms every {} ms: false warning for {} ms without a code",
                            run.vehicle, run.drive, describe(run.fault), to_string(run.fault.place),
                            run.burst_ms, run.period_ms, run.without_code_ms));
        }
    }
    return found;
}

}  // namespace sil
