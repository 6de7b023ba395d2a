// The fault matrix as a page.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "sil/studies/faults/contradiction.hpp"
#include "sil/studies/faults/fault_matrix.hpp"
#include "sil/studies/faults/unseen.hpp"

namespace sil {
namespace {

std::string describe_cell(const FaultCell& cell) {
    std::vector<Reaction> reactions;
    std::vector<std::string> shortfalls;
    std::size_t unseen = 0U;
    for (const Injection& injection : cell) {
        reactions.push_back(injection.reaction);
        const std::vector<std::string>& more = injection.verdict.shortfalls;
        shortfalls.insert(shortfalls.end(), more.begin(), more.end());
        unseen += injection.verdict.unseen.empty() ? 0U : 1U;
    }
    std::string text = describe(reactions);
    if (unseen > 0U) {
        text += fmt::format(", {} of {} [unseen](#what-no-check-sees-in-time)", unseen, cell.size());
    }
    if (!shortfalls.empty()) {
        text += fmt::format(" **NOT: {}**", fmt::join(shortfalls, "; "));
    }
    return text;
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
        const char* const sign = stated.sign == 0 ? "" : (stated.sign > 0 ? ", positive" : ", negative");
        text +=
            fmt::format("| {}{} | {} | {} | {} | {}{} |\n", to_string(stated.kind), sign,
                        to_string(stated.place), describe_limits(stated), describe_lapse(stated), stated.why,
                        stated.wrong_ms == Contradiction{}.wrong_ms
                            ? ""
                            : fmt::format("; wrong for {} ms at most", stated.wrong_ms));
    }
    return text;
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

std::string table(const FaultMatrix& matrix) {
    std::string text = "| fault | of | expected |";
    std::string line = "|---|---|---|";
    for (const Scene& scene : first_of_each_name(matrix)) {
        text += fmt::format(" {} |", scene.name);
        line += "---|";
    }
    text += "\n" + line + "\n";
    for (const FaultRow& row : matrix.rows) {
        text += fmt::format("| {} | {} | {} |", describe_each_sign(row.fault), to_string(row.fault.place),
                            describe_expectation(row.fault));
        for (const FaultCell& cell : row.cells) {
            text += fmt::format(" {} |", describe_cell(cell));
        }
        text += "\n";
    }
    return text;
}

// The worst of all.
std::string row_of_size(const FaultCell& cell) {
    const Fault& fault = cell.front().fault;
    std::optional<int> latest;
    std::optional<int> least_lead;
    std::optional<int> code;
    int silence = 0;
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
        silence = std::max(silence, reaction.silence);
        missed = missed || reaction.warning_missed;
    }
    const auto number = [](const std::optional<int>& time) { return time ? fmt::format("{}", *time) : ""; };
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", describe(fault), to_string(fault.place),
                       unavailable, missed ? "never" : fmt::format("{:+}", latest.value_or(0)),
                       missed ? "" : number(least_lead), silence,
                       always_a_code ? number(code) : (code ? number(code) + ", or none" : "none"));
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

std::string unseen_table(const FaultMatrix& matrix) {
    std::string text =
        "| error | of | `unavailable` in time, of 4 | due warning, ms later | before two-wheel lift-off, ms "
        "| `ready` without a code, ms | "
        "first code, ms after the error |\n|---|---|---|---|---|---|---|\n";
    for (const FaultCell& cell : matrix.sizes) {
        text += is_late(cell) ? row_of_size(cell) : "";
    }
    text += "\n";
    for (const Unseen& each : unseen_errors()) {
        const char* const sign = each.sign == 0 ? "" : (each.sign < 0 ? ", negative" : ", positive");
        text +=
            fmt::format("- {} of {}{}: {}.\n", to_string(each.kind), to_string(each.place), sign, each.why);
    }
    return text;
}

std::string headline(const InjectionCount& count) {
    const std::size_t silenced = count.silenced - count.silenced_unseen;
    return fmt::format(
        "**Of {} injections {} are answered as expected; of these {} were never visible (no value was wrong "
        "by "
        "as much as matters), so that {} show something. {} are [errors that no check\nsees in "
        "time](#what-no-check-sees-in-time) and make the warning late; {} fall short otherwise. A warning is "
        "due in {}: {} of them turn it into `ready` without a diagnostic code,\nall {} by those "
        "errors{}**. Errors of other sizes can do more than those of the matrix: [the same "
        "section](#what-no-check-sees-in-time). What falls short otherwise fails the run, and says here "
        "after **NOT** what is "
        "missing.\n\n",
        count.all, count.as_expected, count.invisible, count.as_expected - count.invisible, count.unseen,
        count.all - count.as_expected - count.unseen, count.with_due_warning, count.silenced,
        count.silenced_unseen, silenced == 0U ? "" : fmt::format(", and {} by others", silenced));
}

}  // namespace

std::string fault_matrix_document(const FaultMatrix& matrix) {
    const InjectionCount count = count_injections(matrix);
    return fmt::format(
        "# Fault matrix\n\n"
        "Written by `sil/studies/faults/run --document`; `tests/run faults` runs it again and fails when a "
        "figure "
        "differs. Each fault is injected into each scene, in\nprocess and in simulated time (the large SUV, "
        "sensors with noise), and the ECU's frames are compared with those of the same drive without it.\n\n"
        "{}"
        "## Scenes\n{}\n"
        "All J-turns are to the left; an error of either sign in them is the same error in turns to both "
        "sides.\n\n"
        "## How to read a cell\n"
        "A cell is the worst of both signs of the error and of all the scene's beginnings; \"(3 of 4)\" says "
        "in "
        "how many of them. All times are in milliseconds, in steps of a cycle. A\nreaction counts from the "
        "cycle in which the fault became visible: a frame is missing or wrong, or a value is wrong by the "
        "least visible error. It is negative when it came before.\n\"back\" counts from the end of the fault "
        "to the cycle from which on state, degradation and roll source stay those of the drive without it, "
        "\"codes gone\" to that from which on no further code\nis told (until two wheels lift: with them in "
        "the air the vehicle is no longer what the checks know). \"warning -80 to +20\": the due warning "
        "came "
        "80 ms earlier to 20 ms later.\n\"not visible\": no value was wrong by as much.\n\n"
        "In every cell: every computed cycle sends every frame, once and protected; no code that the DBC "
        "file does not define; the watchdog is fed once a cycle; a due warning is\nnever `ready` without "
        "any diagnostic code (but for what no check sees in time, below); a warning without reason lasts at "
        "most the reaction time and the 2000 ms for "
        "which every warning is held, and there is none where the\nfault need not show; the last code is "
        "gone 1.65 s after the fault at the latest.\n\n"
        "What is expected: \"code, ...\": a diagnostic code within so many milliseconds, and the reaction "
        "that is named within the same time; where the state must stay usable, the due\nwarning comes at "
        "most "
        "100 ms late, or as late as the limit is, **and always {} ms before two wheels lift** (without a "
        "fault: "
        "{} ms before): a driver who has less cannot act. \"all the time\": from then on\nthere is a code in "
        "every cycle until the fault ends. Seven limits are those of the three scenes, the two beginnings "
        "before the turn and the two before the warning; \"-\", and \"right\": nothing\nthat the vehicle "
        "does "
        "there tells the value from the truth, so that no code is needed as long as the statement is that of "
        "the drive without the fault: never `unavailable`, another state\nfor at most 100 ms (or as stated "
        "below), the due warning at most 100 ms late. Of a fault that is over before the warning only what "
        "follows is judged: the warning at most 100 ms late where\n\"back\" is not above 200 ms, and else by "
        "no more than \"back\" takes.\n\n"
        "{}\n"
        "## What no check sees in time\n"
        "Errors that take away from the level, and are too small for a check or found too late. Every offset "
        "and "
        "drift of the matrix was injected in eight sizes, a quarter to three times the matrix's, "
        "with\neither "
        "sign, in the four J-turns in which it is there when the warning is due; here is each size that "
        "makes the "
        "warning more than {} ms later, or `ready` without a code for a\nwhile, and the worst of those turns "
        "in "
        "which the ECU is not `unavailable` in time. Without an error the warning comes {} ms before two "
        "wheels "
        "lift; negative: after that.\n\n"
        "{}\n"
        "## Limits of values that contradict others\n"
        "Rest / straight / turn / 0.5 s before the driver steers / as he steers / 0.3 s before the warning / "
        "0.1 "
        "s before it, from the least visible error on: the debounce of\n[degradation.md](degradation.md) and "
        "the time until something moves, as measured here and rounded up to 50 ms. A slower ECU fails.\n\n"
        "{}",
        headline(count), scene_list(matrix), least_lead_ms, matrix.lead_ms, table(matrix),
        longest_lead_loss_ms, matrix.lead_ms, unseen_table(matrix), contradiction_table());
}

}  // namespace sil
