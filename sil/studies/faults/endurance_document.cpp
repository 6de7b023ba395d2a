// The endurance page.
#include <fmt/format.h>

#include "sil/studies/faults/endurance.hpp"

namespace sil {

std::string endurance_row(const EnduranceSettings& settings, const EnduranceResult& result) {
    return fmt::format(
        "| {:g} | {} | {} ({}) | {} | {} | {} | {} | {} / {} / {} | {} | {} | {} | {} | {} of {} | {:.3f} | "
        "{:.3f} |\n",
        settings.hours, settings.seed, result.faults, result.pairs, result.stops, result.rollovers,
        result.warnings_due, result.due_with_fault, result.due_with_fault_warned, result.due_with_fault_told,
        result.due_with_fault_silenced, result.silenced_by.size(), result.longest_silence_ms,
        result.incomplete_cycles + result.undefined_cycles + result.unfed_cycles + result.bad_outputs,
        fmt::format("{}{}", result.longest_recovery_ms,
                    result.not_recovered_from.empty()
                        ? ""
                        : fmt::format(", {} not", result.not_recovered_from.size())),
        result.recovered_at_standstill, result.over_at_standstill, result.largest_roll_centre_deviation_m,
        result.largest_roll_centre_movement_m);
}

std::string endurance_document(const std::string& rows) {
    return "# Endurance: hours of driving with random faults\n\n"
           "Written by `sil/studies/faults/run --endurance`; `tests/run faults` drives the first row again "
           "and fails "
           "when a figure differs.\n\n"
           "A simulated large SUV goes straight, turns to both sides, changes lanes and weaves by chance, at "
           "30 to "
           "110 km/h on a level road, with sensor noise; four in ten turns are\nmeant for 0.5 to 0.9 g. "
           "Every 0.5 "
           "to 5 minutes it stops for 3 to 40 s. Who rolls over gets a new vehicle. 1 to 20 s after the ECU "
           "has "
           "recovered from a fault, the next one of the\n[fault matrix](fault_matrix.md), drawn from all of "
           "them "
           "and with either sign, lasts 0.05 to 5 s; in one of four cases a second one, of another signal or "
           "frame, "
           "begins within 2 s of it.\nFaults are drawn towards hard turns: in four of five cases one that "
           "has not "
           "begun yet is moved to begin at most 3 s before a warning is due. One ECU drives through all of "
           "it and is "
           "never\nstarted anew; a second one sees the same drive without faults, and says what would be "
           "right.\n\n"
           "| hours | seed | faults (pairs) | stops | rollovers | warnings due | of these with a fault | "
           "warned / told "
           "/ silenced | silenced otherwise | longest silence, ms | bad cycles | longest recovery, ms | "
           "recovered "
           "standing | roll centre: largest deviation, m | largest movement, m |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n" +
           rows +
           "\n- **warnings due**: how often the second ECU came to warn; **with a fault**: of these, how "
           "often a "
           "fault was there, or had been within 2 s, in a cycle in which the level of the second was not\n  "
           "below "
           "`warning_off` (below that it merely holds its warning for two seconds).\n"
           "- **warned / told / silenced**: of those with a fault, how often the first ECU warned too; did "
           "not, but "
           "was `unavailable` or told a code; was `ready` without any diagnostic code, if only for a\n  "
           "cycle. What "
           "is missing said `advisory`. **silenced otherwise**: without one of the [errors that no check "
           "sees in "
           "time](fault_matrix.md#what-no-check-sees-in-time) among the faults, which fails the\n  run, with "
           "or "
           "without a fault; **longest silence**: the longest such time of all.\n"
           "- **bad cycles**: a frame is missing or damaged, a code is on the bus that the DBC file does not "
           "define, the watchdog was not fed once, an output is infinite, or one that is needed for the\n  "
           "statement "
           "is not a number, or an estimate is beyond what the bus can carry.\n"
           "- **longest recovery**: from the end of the last fault until availability, degradation and roll "
           "source "
           "are those of the second ECU and no further code is left, for a second. More than\n  10,000 ms "
           "would "
           "count as stuck (\"1 not\"), and fail the run. Time at a standstill does not count: **recovered "
           "standing** says of "
           "how many "
           "faults that ended there the ECU had recovered before it moved again.\n"
           "- **roll centre**: the largest standard deviation that the estimator gave itself, and the "
           "largest "
           "vertical movement that it estimated: its covariance stays bounded.\n\n"
           "The firmware has no heap (`tests/run application`), so its memory cannot grow.\n";
}

}  // namespace sil
