// The fault matrix as a page.
#include <fmt/format.h>

#include <algorithm>

#include "sil/faults/contradiction.hpp"
#include "sil/faults/fault_matrix.hpp"

namespace sil {
namespace {

std::string describe_cell(const FaultCell& cell) {
    return cell.shortfalls.empty()
               ? describe(cell.reaction)
               : fmt::format("{} **NOT: {}**", describe(cell.reaction), fmt::join(cell.shortfalls, "; "));
}

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

std::string describe_expectation(const Fault& fault) {
    Demand demand = Demand::right;
    Expectation expected;
    for (std::size_t scene = 0U; scene < scene_count; ++scene) {
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
                       contradicts(fault) ? describe_limits(contradiction_of(fault))
                                          : fmt::format("{}{}", expected.reaction_ms,
                                                        expected.lapse_ms == 0 ? ", all the time" : ""),
                       expected.recovery_ms);
}

bool shows_somewhere(const Contradiction& stated) {
    return std::any_of(stated.limits_ms.begin(), stated.limits_ms.end(),
                       [](int limit_ms) { return limit_ms != hidden; });
}

std::string describe_lapse(const Contradiction& stated) {
    if (!shows_somewhere(stated)) {
        return "";
    }
    return stated.lapse_ms == any_time_ms ? "any time" : fmt::format("{}", stated.lapse_ms);
}

std::string contradiction_table() {
    std::string text =
        "| fault | of | limit, ms | no code again, ms | what the limit is made of, or why nothing shows "
        "|\n|---|---|---|---|---|\n";
    for (const Contradiction& stated : contradictions()) {
        text += fmt::format("| {} | {} | {} | {} | {}{} |\n", to_string(stated.kind), to_string(stated.place),
                            describe_limits(stated), describe_lapse(stated), stated.why,
                            stated.wrong_ms == Contradiction{}.wrong_ms
                                ? ""
                                : fmt::format("; wrong for {} ms at most", stated.wrong_ms));
    }
    return text;
}

std::string scene_list(const FaultMatrix& matrix) {
    std::string text;
    for (const Scene& scene : matrix.scenes) {
        text += fmt::format("- **{}**: {}\n", scene.name, scene.description);
    }
    return text;
}

std::string table(const FaultMatrix& matrix) {
    std::string text = "| fault | of | expected |";
    std::string line = "|---|---|---|";
    for (const Scene& scene : matrix.scenes) {
        text += fmt::format(" {} |", scene.name);
        line += "---|";
    }
    text += "\n" + line + "\n";
    for (const FaultRow& row : matrix.rows) {
        text += fmt::format("| {} | {} | {} |", describe(row.fault), to_string(row.fault.place),
                            describe_expectation(row.fault));
        for (const FaultCell& cell : row.cells) {
            text += fmt::format(" {} |", describe_cell(cell));
        }
        text += "\n";
    }
    return text;
}

}  // namespace

std::string fault_matrix_document(const FaultMatrix& matrix) {
    const CellCount count = count_cells(matrix);
    return fmt::format(
        "# Fault matrix\n\n"
        "Written by `sil/faults/run --document`; `tests/run faults` runs it again and fails when a figure "
        "differs. Each fault is injected into each scene, in\nprocess and in simulated time (the large SUV, "
        "sensors with noise), and the ECU's frames are compared with those of the same drive without it.\n\n"
        "**{} of {} cells are as expected. In {} of the {} cells in which a warning is due a single fault "
        "turns "
        "it into `ready` without a diagnostic code**, not for one cycle. A cell\nthat falls short fails the "
        "run, "
        "and says here after **NOT** what is missing.\n\n"
        "## Scenes\n{}\n"
        "## How to read a cell\n"
        "All times are in milliseconds, in steps of a cycle. A reaction counts from the cycle in which the "
        "fault became visible: a frame is missing or wrong, or a\nvalue is wrong by the least visible "
        "error. It is negative when it came before. \"back\" counts from the end of the fault to the cycle "
        "from which on state, degradation and\nroll source stay those of the drive without it, \"codes "
        "gone\" to that from which on no further code is told. \"warning +20\": "
        "the due warning came 20 ms later. \"not visible\": no value was wrong by as much.\n\n"
        "In every cell: every computed cycle sends every frame, once and protected; no code that the DBC "
        "file does not define; the watchdog is fed once a cycle; a due warning is\nnever `ready` without "
        "any diagnostic code; a warning without reason lasts at most the reaction time and the 2000 ms for "
        "which every warning is held, and there is none where the\nfault need not show; the last code is "
        "gone 1.65 s "
        "after the fault at the latest.\n\n"
        "What is expected: \"code, ...\": a diagnostic code within so many milliseconds, and the reaction "
        "that "
        "is named within the same time; where the state must stay usable, the due\nwarning comes at most 100 "
        "ms "
        "late, or as late as the limit is. \"all the time\": from then on there is a code in every cycle "
        "until "
        "the fault ends. Five limits are those of the\nfive scenes; \"-\", and \"right\": nothing that the "
        "vehicle does there tells the value from the truth, so that no code is needed as long as the "
        "statement "
        "is that of the drive\nwithout the fault: never `unavailable`, another state for at most 100 ms (or "
        "as "
        "stated below), the due warning at most 100 ms late.\n\n"
        "{}\n"
        "## Limits of values that contradict others\n"
        "Rest / straight / turn / before the turn / warning, from the least visible error on: the debounce "
        "of "
        "[degradation.md](degradation.md) and the time until something moves, as measured\nhere and rounded "
        "up "
        "to 50 ms. A slower ECU fails.\n\n"
        "{}",
        count.as_expected, count.all, count.silenced == 0U ? "none" : fmt::format("{}", count.silenced),
        count.with_due_warning, scene_list(matrix), table(matrix), contradiction_table());
}

}  // namespace sil
