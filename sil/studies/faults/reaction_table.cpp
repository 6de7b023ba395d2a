#include "sil/studies/faults/reaction_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace sil {
namespace {

std::string cell_of(const std::optional<int>& time) {
    return time ? fmt::format("{}", *time) : "";
}

std::vector<TableCell> row_of(const std::string& name, const std::vector<Reaction>& reactions) {
    std::size_t invisible = 0U;
    std::size_t with_code = 0U;
    std::size_t due = 0U;
    std::size_t missed = 0U;
    std::optional<int> slowest;
    std::optional<int> latest;
    for (const Reaction& reaction : reactions) {
        invisible += reaction.visible ? 0U : 1U;
        with_code += reaction.code ? 1U : 0U;
        due += reaction.warning_due ? 1U : 0U;
        missed += reaction.warning_missed ? 1U : 0U;
        slowest = std::max(slowest, reaction.code);
        latest = std::max(latest, reaction.lead_loss);
    }
    return {name,
            reactions.size(),
            invisible,
            with_code,
            cell_of(slowest),
            due,
            missed,
            latest ? fmt::format("{:+}", *latest) : ""};
}

}  // namespace

const std::vector<std::string>& reaction_columns() {
    static const std::vector<std::string> columns{
        "visible",       "unavailable",   "observer",      "motion_lost",   "code",
        "code_name",     "warning_later", "warning_never", "ready_no_code", "wrong_no_code",
        "lapse_of_code", "false_warning", "back",          "codes_gone"};
    return columns;
}

void add_reaction(CsvRow& row, const Reaction& reaction) {
    row.text(reaction.visible ? "yes" : "no")
        .text(cell_of(reaction.unavailable))
        .text(cell_of(reaction.observer))
        .text(cell_of(reaction.motion_lost))
        .text(cell_of(reaction.code))
        .text(reaction.code_name)
        .text(cell_of(reaction.lead_loss))
        .text(reaction.warning_missed ? "yes" : "")
        .text(cell_of(reaction.silence))
        .text(cell_of(reaction.wrong))
        .text(cell_of(reaction.lapse))
        .text(cell_of(reaction.false_warning))
        .text(cell_of(reaction.recovery))
        .text(cell_of(reaction.healing));
}

void GroupedReactions::add(std::string_view group, const Reaction& reaction) {
    auto found = std::find_if(groups_.begin(), groups_.end(),
                              [group](const auto& each) { return each.first == group; });
    if (found == groups_.end()) {
        found = groups_.emplace(groups_.end(), std::string{group}, std::vector<Reaction>{});
    }
    found->second.push_back(reaction);
}

Table GroupedReactions::table(std::string heading) const {
    Table table;
    table.columns = {
        {std::move(heading)},      {"runs", 0},        {"never visible", 0}, {"with a code", 0},
        {"slowest code", 0, "ms"}, {"warning due", 0}, {"not given", 0},     {"latest", 0, "ms"}};
    table.numbers_right = true;
    for (const auto& [name, reactions] : groups_) {
        table.rows.push_back(row_of(name, reactions));
    }
    return table;
}

}  // namespace sil
