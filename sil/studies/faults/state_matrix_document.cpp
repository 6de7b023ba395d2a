// The state matrix as a page and as a data file.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "page_templates.hpp"
#include "sil/studies/faults/contradiction.hpp"
#include "sil/studies/faults/expectation.hpp"
#include "sil/studies/faults/known_undetected.hpp"
#include "sil/studies/faults/page_template.hpp"
#include "sil/studies/faults/reaction_table.hpp"
#include "sil/studies/faults/state_matrix.hpp"

namespace sil {
namespace {

std::string list_states(const std::vector<DrivingState>& states, std::size_t begin) {
    std::string text;
    for (std::size_t index = begin; index < states.size(); ++index) {
        text += fmt::format("- **{}**: {}\n", states[index].name, states[index].description);
    }
    return text;
}

using Name = std::function<std::string(const StateRow& row, const DrivingState& state)>;

std::string table(const char* heading, const std::vector<StateRow>& rows,
                  const std::vector<DrivingState>& states, const Name& group_of) {
    GroupedReactions grouped;
    for (const StateRow& row : rows) {
        for (std::size_t state = 0U; state < row.cells.size(); ++state) {
            for (const StateOutcome& outcome : row.cells[state]) {
                grouped.add(group_of(row, states[state]), outcome.reaction);
            }
        }
    }
    return markdown(grouped.table(heading));
}

std::string name_of_kind(const StateRow& row, const DrivingState& /*state*/) {
    return to_string(row.fault.kind);
}

std::string name_of_state(const StateRow& /*row*/, const DrivingState& state) {
    return state.name;
}

std::string name_of_sensors(const StateRow& row, const DrivingState& /*state*/) {
    return row.sensors;
}

std::string lines_of(const std::vector<StateRow>& rows, const std::vector<DrivingState>& states) {
    std::string text;
    for (const StateRow& row : rows) {
        for (std::size_t state = 0U; state < row.cells.size(); ++state) {
            for (const StateOutcome& outcome : row.cells[state]) {
                CsvRow line;
                line.text(outcome.name)
                    .text(row.fault.kind == FaultKind::none ? "" : to_string(row.fault.place))
                    .text(states[state].name);
                add_reaction(line, outcome.reaction);
                std::vector<std::string> findings;
                for (const FindingKind kind : outcome.findings) {
                    findings.emplace_back(to_string(kind));
                }
                text += line.text(fmt::format("{}", fmt::join(findings, "; "))).line() + "\n";
            }
        }
    }
    return text;
}

// A failure of a signal in all its sizes and signs.
struct Failure {
    FaultPlace place{};
    FaultKind kind{};
    std::set<std::string> codes{};
    std::vector<std::vector<Reaction>> by_state{};
};

std::vector<Failure> failures_in(const StateMatrix& matrix) {
    std::vector<Failure> all;
    for (const StateRow& row : matrix.rows) {
        auto failure = std::find_if(all.begin(), all.end(), [&row](const Failure& each) {
            return each.place == row.fault.place && each.kind == row.fault.kind;
        });
        if (failure == all.end()) {
            failure = all.insert(all.end(), {row.fault.place, row.fault.kind, {}, {}});
            failure->by_state.resize(matrix.states.size());
        }
        for (std::size_t state = 0U; state < row.cells.size(); ++state) {
            for (const StateOutcome& outcome : row.cells[state]) {
                failure->by_state[state].push_back(outcome.reaction);
                if (outcome.reaction.code) {
                    failure->codes.insert(outcome.reaction.code_name);
                }
            }
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Failure& left, const Failure& right) { return left.place < right.place; });
    return all;
}

// "7 of 8, 320"
std::string cell_of_failure(const std::vector<Reaction>& reactions) {
    std::size_t visible = 0U;
    std::size_t found = 0U;
    std::optional<int> slowest;
    for (const Reaction& reaction : reactions) {
        visible += reaction.visible ? 1U : 0U;
        found += reaction.visible && reaction.code ? 1U : 0U;
        slowest = reaction.visible ? std::max(slowest, reaction.code) : slowest;
    }
    if (visible == 0U) {
        return "";
    }
    return fmt::format("{} of {}", found, visible) + (slowest ? fmt::format(", {}", *slowest) : "");
}

// The latest of the runs without a code.
std::string latest_warning(const Failure& failure) {
    std::optional<int> latest;
    for (const std::vector<Reaction>& reactions : failure.by_state) {
        for (const Reaction& reaction : reactions) {
            if (reaction.code || reaction.unavailable || !reaction.visible) {
                continue;
            }
            if (reaction.warning_missed) {
                return "never";
            }
            latest = std::max(latest, reaction.lead_loss);
        }
    }
    return latest ? fmt::format("{:+}", *latest) : "";
}

bool is_always_found(const Failure& failure) {
    for (const std::vector<Reaction>& reactions : failure.by_state) {
        for (const Reaction& reaction : reactions) {
            if (reaction.visible && !reaction.code) {
                return false;
            }
        }
    }
    return true;
}

// The lists that hold the limits of the checks have the reasons.
std::string why_not_found(const Failure& failure) {
    if (is_always_found(failure)) {
        return "";
    }
    for (const std::vector<KnownUndetected>& list : {known_undetected_errors(), undetected_in_states()}) {
        for (const KnownUndetected& each : list) {
            if (each.kind == failure.kind && each.place == failure.place) {
                return each.why;
            }
        }
    }
    for (const KnownFinding& each : known_findings()) {
        if (each.found.fault == failure.kind && each.found.place == failure.place) {
            return each.why;
        }
    }
    for (const Contradiction& each : contradictions()) {
        if (each.kind == failure.kind && each.place == failure.place) {
            return each.why;
        }
    }
    return "";
}

std::string detection_table(const StateMatrix& matrix) {
    Table table;
    table.columns = {{"of"}, {"failure"}, {"found by"}};
    for (const DrivingState& state : matrix.states) {
        table.columns.push_back({state.name});
    }
    table.columns.push_back({"warning, ms later"});
    table.columns.push_back({"why not"});
    for (const Failure& failure : failures_in(matrix)) {
        std::vector<TableCell> cells{to_string(failure.place), to_string(failure.kind),
                                     fmt::format("{}", fmt::join(failure.codes, ", "))};
        for (const std::vector<Reaction>& reactions : failure.by_state) {
            cells.emplace_back(cell_of_failure(reactions));
        }
        cells.emplace_back(latest_warning(failure));
        cells.emplace_back(why_not_found(failure));
        table.rows.push_back(std::move(cells));
    }
    return markdown(table);
}

// "630 ms before; CODE after 90 s", or what is said instead of a warning.
std::string cell_of_offset(const Reaction& reaction) {
    const std::string code =
        reaction.code ? fmt::format("{} after {:.0f} s", reaction.code_name, *reaction.code / 1000.0) : "";
    if (!reaction.lead) {
        return reaction.code ? code : "no warning";
    }
    return fmt::format("{} ms before{}{}", *reaction.lead, code.empty() ? "" : "; ", code);
}

std::string offset_table(const StateMatrix& matrix) {
    Table table;
    table.columns = {{"failure"}};
    for (const DrivingState& state : matrix.states_of_offsets) {
        table.columns.push_back({state.name});
    }
    for (const StateRow& row : matrix.rows_of_offsets) {
        std::vector<TableCell> cells{describe(row.fault)};
        for (const StateCell& cell : row.cells) {
            cells.emplace_back(cell_of_offset(cell.front().reaction));
        }
        table.rows.push_back(std::move(cells));
    }
    return markdown(table);
}

std::string known_table() {
    Table table;
    table.columns = {{"finding"}, {"where"}, {"why"}};
    for (const KnownFinding& each : known_findings()) {
        table.rows.push_back({describe(each.found),
                              each.cells.empty() ? "only in the [search](fault_search.md)"
                                                 : fmt::format("{} cells", each.cells.size()),
                              each.why});
    }
    return markdown(table);
}

std::string headline_of(const StateMatrix& matrix) {
    std::size_t injections = 0U;
    std::size_t with_finding = 0U;
    std::map<FindingKind, std::size_t> kinds;
    const auto count = [&](const std::vector<StateRow>& rows) {
        for (const StateRow& row : rows) {
            for (const StateCell& cell : row.cells) {
                for (const StateOutcome& outcome : cell) {
                    ++injections;
                    with_finding += outcome.findings.empty() ? 0U : 1U;
                    for (const FindingKind kind : outcome.findings) {
                        ++kinds[kind];
                    }
                }
            }
        }
    };
    count(matrix.rows);
    count(matrix.rows_of_offsets);
    count(matrix.rows_of_good_sensors);
    std::vector<std::string> parts;
    for (const auto& [kind, number] : kinds) {
        parts.push_back(fmt::format("{} {}", to_string(kind), number));
    }
    return fmt::format("**{} runs, {} of them with a finding, all of them [known](#known-findings):\n{}.**",
                       injections, with_finding, fmt::join(parts, ", "));
}

}  // namespace

std::string state_matrix_document(const StateMatrix& matrix) {
    return fill_template(fault_states_template,
                         {{"headline", headline_of(matrix)},
                          {"states", list_states(matrix.states, 0U)},
                          {"least_lead_ms", fmt::format("{}", least_lead_ms)},
                          {"lead_loss_ms", fmt::format("{}", longest_lead_loss_ms)},
                          {"longest_false_ms", fmt::format("{}", longest_false_warning_without_code_ms)},
                          {"nearby_s", fmt::format("{}", warning_nearby_ms / 1000)},
                          {"large_load_transfer", fmt::format("{}", large_load_transfer)},
                          {"sender_ms", fmt::format("{}", second_sender_shows_ms)},
                          {"start_ms", fmt::format("{}", start_ms)},
                          {"kinds", table("fault", matrix.rows, matrix.states, name_of_kind)},
                          {"by_state", table("state", matrix.rows, matrix.states, name_of_state)},
                          {"detection", detection_table(matrix)},
                          {"offset_states", list_states(matrix.states_of_offsets, 0U)},
                          {"offsets", offset_table(matrix)},
                          {"drives", list_states(matrix.states_of_good_sensors, matrix.states.size())},
                          {"good_sensors", table("sensors", matrix.rows_of_good_sensors,
                                                 matrix.states_of_good_sensors, name_of_sensors)},
                          {"known", known_table()}});
}

std::string state_matrix_data(const StateMatrix& matrix) {
    std::vector<std::string> columns{"fault_or_sensors", "of", "state"};
    columns.insert(columns.end(), reaction_columns().begin(), reaction_columns().end());
    columns.emplace_back("finding");
    return csv_header(columns) + "\n" + lines_of(matrix.rows, matrix.states) +
           lines_of(matrix.rows_of_offsets, matrix.states_of_offsets) +
           lines_of(matrix.rows_of_good_sensors, matrix.states_of_good_sensors);
}

}  // namespace sil
