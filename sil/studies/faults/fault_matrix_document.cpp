// The fault matrix as a page and as a data file.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "page_templates.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/studies/faults/contradiction.hpp"
#include "sil/studies/faults/fault_matrix.hpp"
#include "sil/studies/faults/known_undetected.hpp"
#include "sil/studies/faults/page_template.hpp"
#include "sil/studies/faults/reaction_table.hpp"

namespace sil {
namespace {

std::string describe_limit(int limit_ms) {
    return limit_ms == hidden ? "-" : fmt::format("{}", limit_ms);
}

// "450" or, when they differ from scene to scene, "- / - / 450 / 50 / 100".
std::string describe_limits(const Contradiction& stated) {
    const auto& limits = stated.limits_ms;
    const bool same =
        std::all_of(limits.begin(), limits.end(), [&limits](int each) { return each == limits.front(); });
    std::string text = describe_limit(limits.front());
    for (std::size_t scene = 1U; scene < limits.size() && !same; ++scene) {
        text += " / " + describe_limit(limits[scene]);
    }
    return text;
}

bool contradicts(const Fault& fault) {
    return fault.kind >= FaultKind::frozen && fault.kind <= FaultKind::sign_flip;
}

std::string describe_limits_of_each_sign(const Fault& fault) {
    std::vector<std::string> limits;
    for (const Fault& each : in_each_sign(fault)) {
        limits.push_back(describe_limits(contradiction_of(each)));
    }
    return limits.front() == limits.back()
               ? limits.front()
               : fmt::format("{} (positive), {} (negative)", limits.front(), limits.back());
}

std::string describe_expectation(const Fault& fault) {
    Demand demand = Demand::right;
    Expectation expected;
    for (std::size_t scene = 0U; scene < static_cast<std::size_t>(SceneKind::over); ++scene) {
        expected = expectation_of(fault, static_cast<SceneKind>(scene));
        demand = std::max(demand, expected.demand);
    }
    if (expected.demand == Demand::unaffected) {
        return fmt::format("no change; back {}", expected.recovery_ms);
    }
    if (demand == Demand::right) {
        return fmt::format("right; back {}", expected.recovery_ms);
    }
    return fmt::format("{} {}; back {}", to_string(demand),
                       contradicts(fault) ? describe_limits_of_each_sign(fault)
                                          : fmt::format("{}{}", expected.reaction_ms,
                                                        expected.lapse_ms == 0 ? ", all the time" : ""),
                       expected.recovery_ms);
}

std::vector<std::reference_wrapper<const Scene>> first_of_each_name(const FaultMatrix& matrix) {
    std::vector<std::reference_wrapper<const Scene>> scenes;
    for (const Scene& scene : matrix.scenes) {
        if (scenes.empty() || scenes.back().get().name != scene.name) {
            scenes.emplace_back(scene);
        }
    }
    return scenes;
}

std::string scene_list(const FaultMatrix& matrix) {
    std::string text;
    for (const Scene& scene : first_of_each_name(matrix)) {
        text += fmt::format("- **{}**: {}\n", scene.name, scene.description);
    }
    return text;
}

std::string table(const FaultMatrix& matrix, const char* heading,
                  const std::function<std::string(const Injection&)>& group_of) {
    GroupedReactions grouped;
    for (const FaultRow& row : matrix.rows) {
        for (const FaultCell& cell : row.cells) {
            for (const Injection& injection : cell) {
                grouped.add(group_of(injection), injection.reaction);
            }
        }
    }
    return markdown(grouped.table(heading));
}

// The worst of all.
std::vector<TableCell> row_of_size(const FaultCell& cell) {
    const Fault& fault = cell.front().fault;
    std::optional<int> latest;
    std::optional<int> least_lead;
    std::optional<int> code;
    std::size_t silence = 0U;
    bool always_a_code = true;
    bool missed = false;
    std::size_t unavailable = 0U;
    for (const Injection& injection : cell) {
        const Reaction& reaction = injection.reaction;
        if (reaction.unavailable && !silences_a_warning(reaction)) {  // found, and it says so
            ++unavailable;
            continue;
        }
        latest = std::max(latest, reaction.lead_loss);
        least_lead = least_lead ? std::min(*least_lead, reaction.lead.value_or(*least_lead)) : reaction.lead;
        code = std::max(code, reaction.code);
        always_a_code = always_a_code && reaction.code.has_value();
        silence = std::max(silence, static_cast<std::size_t>(reaction.silence));
        missed = missed || reaction.warning_missed;
    }
    const auto number = [](const std::optional<int>& time) { return time ? fmt::format("{}", *time) : ""; };
    return {describe(fault),
            to_string(fault.place),
            unavailable,
            missed ? "never" : fmt::format("{:+}", latest.value_or(0)),
            missed ? "" : number(least_lead),
            silence,
            always_a_code ? number(code) : (code ? number(code) + ", or none" : "none")};
}

// Later than a warning may be, or silent, without saying that it is unavailable.
bool is_late(const FaultCell& cell) {
    return std::any_of(cell.begin(), cell.end(), [](const Injection& injection) {
        const Reaction& reaction = injection.reaction;
        return silences_a_warning(reaction) ||
               (!reaction.unavailable &&
                (reaction.warning_missed || reaction.lead_loss.value_or(0) > longest_lead_loss_ms));
    });
}

std::string known_undetected_table(const FaultMatrix& matrix) {
    Table table;
    table.columns = {{"error"},
                     {"of"},
                     {"`unavailable` in time, of 4"},
                     {"due warning, ms later"},
                     {"before two-wheel lift-off, ms"},
                     {"`ready` without a code, ms"},
                     {"first code, ms after the error"}};
    for (const FaultCell& cell : matrix.sizes) {
        if (is_late(cell)) {
            table.rows.push_back(row_of_size(cell));
        }
    }
    std::string text = markdown(table) + "\n";
    for (const KnownUndetected& each : known_undetected_errors()) {
        const char* const sign = each.sign == 0 ? "" : (each.sign < 0 ? ", negative" : ", positive");
        text +=
            fmt::format("- {} of {}{}: {}.\n", to_string(each.kind), to_string(each.place), sign, each.why);
    }
    return text;
}

std::string headline(const InjectionCount& count) {
    const std::size_t silenced = count.silenced - count.silenced_known_undetected;
    return fmt::format(
        "**{} injections, {} of them answered as expected; {} of these were never visible (no value was "
        "wrong "
        "by the least visible\nerror), so {} show a reaction. {} are "
        "[known undetected faults](#known-undetected-faults) and make the warning late; {} fall\nshort "
        "otherwise. A warning is due in {}: {} of them turn it into `ready` without a diagnostic code, {} by "
        "known undetected\nfaults{}.**",
        count.all, count.as_expected, count.invisible, count.as_expected - count.invisible,
        count.known_undetected, count.all - count.as_expected - count.known_undetected,
        count.with_due_warning, count.silenced, count.silenced_known_undetected,
        silenced == 0U ? "" : fmt::format(", and {} by others", silenced));
}

}  // namespace

std::string fault_matrix_document(const FaultMatrix& matrix) {
    const auto kind_of = [](const Injection& each) { return std::string{to_string(each.fault.kind)}; };
    const auto place_of = [](const Injection& each) { return std::string{to_string(each.fault.place)}; };
    const auto scene_of = [&matrix](const Injection& each) { return matrix.scenes[each.scene].name; };
    return fill_template(fault_matrix_template,
                         {{"headline", headline(count_injections(matrix))},
                          {"scenes", scene_list(matrix)},
                          {"least_lead_ms", fmt::format("{}", least_lead_ms)},
                          {"lead_ms", fmt::format("{}", matrix.lead_ms)},
                          {"longest_lead_loss_ms", fmt::format("{}", longest_lead_loss_ms)},
                          {"kinds", table(matrix, "fault", kind_of)},
                          {"places", table(matrix, "of", place_of)},
                          {"by_scene", table(matrix, "scene", scene_of)},
                          {"known_undetected", known_undetected_table(matrix)}});
}

std::string fault_matrix_data(const FaultMatrix& matrix) {
    std::vector<std::string> columns{"fault", "of", "expected", "scene", "fault_from_s"};
    columns.insert(columns.end(), reaction_columns().begin(), reaction_columns().end());
    columns.insert(columns.end(), {"known_undetected", "shortfall"});
    std::string text = csv_header(columns) + "\n";
    for (const FaultRow& row : matrix.rows) {
        for (const FaultCell& cell : row.cells) {
            for (const Injection& injection : cell) {
                const Scene& scene = matrix.scenes[injection.scene];
                CsvRow line;
                line.text(describe(injection.fault))
                    .text(to_string(injection.fault.place))
                    .text(describe_expectation(row.fault))
                    .text(scene.name)
                    .text(fmt::format("{:.2f}", static_cast<double>(scene.fault_begin) * cycle_time_s));
                add_reaction(line, injection.reaction);
                line.text(fmt::format("{}", fmt::join(injection.verdict.known_undetected, "; ")))
                    .text(fmt::format("{}", fmt::join(injection.verdict.shortfalls, "; ")));
                text += line.line() + "\n";
            }
        }
    }
    return text;
}

}  // namespace sil
