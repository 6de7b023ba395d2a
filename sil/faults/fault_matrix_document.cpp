// The fault matrix as a page.
#include <fmt/format.h>

#include <algorithm>

#include "sil/faults/fault_matrix.hpp"
#include "sil/faults/known_shortfall.hpp"

namespace sil {
namespace {

// Entries with the same sentence have one number.
std::size_t reason_number(std::size_t entry) {
    const std::vector<KnownShortfall>& all = known_shortfalls();
    std::vector<std::string> reasons;
    for (std::size_t index = 0U; index <= entry; ++index) {
        if (std::find(reasons.begin(), reasons.end(), all[index].why) == reasons.end()) {
            reasons.emplace_back(all[index].why);
        }
    }
    const auto found = std::find(reasons.begin(), reasons.end(), all[entry].why);
    return static_cast<std::size_t>(found - reasons.begin()) + 1U;
}

std::string reason_list() {
    if (known_shortfalls().empty()) {
        return "";
    }
    std::string text{" The others say after **NOT** what is missing, and with a number why:\n\n"};
    std::size_t listed = 0U;
    for (std::size_t entry = 0U; entry < known_shortfalls().size(); ++entry) {
        if (reason_number(entry) > listed) {
            listed = reason_number(entry);
            text += fmt::format("{}. {}\n", listed, known_shortfalls()[entry].why);
        }
    }
    return text;
}

std::string describe_cell(const FaultCell& cell) {
    if (cell.shortfalls.empty()) {
        return describe(cell.reaction);
    }
    return fmt::format("{} **NOT: {}**{}", describe(cell.reaction), fmt::join(cell.shortfalls, "; "),
                       cell.known ? fmt::format(" [{}]", reason_number(*cell.known)) : "");
}

std::string describe_expectation(const Expectation& expected) {
    if (expected.demand == Demand::unaffected) {
        return fmt::format("no change; back {}", expected.recovery_ms);
    }
    return fmt::format("{} {}; back {}", to_string(expected.demand), expected.reaction_ms,
                       expected.recovery_ms);
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
                            describe_expectation(expectation_of(row.fault)));
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
        "**{} of {} cells are as expected.**{}\n\n"
        "## Scenes\n{}\n"
        "## How to read a cell\n"
        "All times are in milliseconds, in steps of a cycle. A reaction counts from the cycle in which the "
        "fault became visible: a frame is missing or wrong, or a\nvalue is wrong by the least visible "
        "error. It is negative when it came before. \"back\" counts from the end of the fault to the cycle "
        "from which on state, degradation and\nroll source stay those of the drive without it, \"codes "
        "gone\" "
        "to that from which on no further code is told. \"warning +20\": "
        "the due warning came 20 ms later. \"not visible\": no value was wrong by as much.\n\n"
        "In every cell: every computed cycle sends every frame, once and protected; no code that the DBC "
        "file does not define; the watchdog is fed once a cycle; while\na warning is due, `ready` without "
        "any diagnostic code lasts at most {} ms; where the state must stay usable, the warning comes at "
        "most {} ms late; a warning without\nreason lasts at most the reaction time and the 2000 ms for "
        "which every warning is held. \"right, or code\": the state is that of the drive without the fault, "
        "but for {} ms, or there is a code; so much is asked of inputs\nthat nothing else in the vehicle "
        "could "
        "contradict and that the warning hardly needs. \"warning kept, or code\": the due warning is at most "
        "100 ms late, or there is a code in time; so much is asked of what shows\nonly while something "
        "moves, or is too small for a while to be told from the road.\n\n"
        "{}",
        count.as_expected, count.all, reason_list(), scene_list(matrix), longest_silence_ms,
        largest_lead_loss_ms, longest_wrong_ms, table(matrix));
}

}  // namespace sil
