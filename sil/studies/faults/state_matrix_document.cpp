// The state matrix as a page.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "page_templates.hpp"
#include "sil/studies/faults/expectation.hpp"
#include "sil/studies/faults/page_template.hpp"
#include "sil/studies/faults/state_matrix.hpp"

namespace sil {
namespace {

std::string of_how_many(std::size_t count, std::size_t all) {
    return all == 1U ? "" : fmt::format(" ({} of {})", count, all);
}

std::string describe_state_cell(const StateCell& cell) {
    if (cell.empty()) {
        return "";
    }
    std::vector<Reaction> reactions;
    std::map<FindingKind, std::size_t> findings;
    for (const StateOutcome& outcome : cell) {
        reactions.push_back(outcome.reaction);
        for (const FindingKind kind : outcome.findings) {
            ++findings[kind];
        }
    }
    std::string text = describe(reactions);
    for (const auto& [kind, count] : findings) {
        text += fmt::format(", **{}**{}", to_string(kind), of_how_many(count, cell.size()));
    }
    return text;
}

std::string list_states(const std::vector<DrivingState>& states, std::size_t begin) {
    std::string text;
    for (std::size_t index = begin; index < states.size(); ++index) {
        text += fmt::format("- **{}**: {}\n", states[index].name, states[index].description);
    }
    return text;
}

std::string heading(const std::string& first, const std::vector<DrivingState>& states) {
    std::string text = first;
    std::string line;
    for (const DrivingState& state : states) {
        text += fmt::format(" {} |", state.name);
    }
    line.reserve(text.size());
    for (const auto column : text.substr(1U)) {
        line += column == '|' ? "---|" : "";
    }
    return fmt::format("{}\n|{}\n", text, line);
}

std::string cells_of(const StateRow& row) {
    std::string text;
    for (const StateCell& cell : row.cells) {
        text += fmt::format(" {} |", describe_state_cell(cell));
    }
    return text + "\n";
}

std::string fault_table(const StateMatrix& matrix) {
    std::string text = heading("| fault | of |", matrix.states);
    for (const StateRow& row : matrix.rows) {
        text += fmt::format("| {} | {} |{}", describe_each_sign(row.fault), to_string(row.fault.place),
                            cells_of(row));
    }
    return text;
}

std::string sensor_table(const StateMatrix& matrix) {
    std::string text = heading("| sensors |", matrix.states_of_good_sensors);
    for (const StateRow& row : matrix.rows_of_good_sensors) {
        text += fmt::format("| {} |{}", row.sensors, cells_of(row));
    }
    return text;
}

std::string known_table() {
    std::string text = "| finding | where | why |\n|---|---|---|\n";
    for (const KnownFinding& each : known_findings()) {
        text += fmt::format("| {} | {} | {} |\n", describe(each.found),
                            each.cells.empty() ? "only in the [search](fault_search.md)"
                                               : fmt::format("{} cells above", each.cells.size()),
                            each.why);
    }
    return text;
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
                          {"faults", fault_table(matrix)},
                          {"drives", list_states(matrix.states_of_good_sensors, matrix.states.size())},
                          {"good_sensors", sensor_table(matrix)},
                          {"known", known_table()}});
}

}  // namespace sil
