#include "sil/studies/faults/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sil {
namespace {

constexpr int cycle_ms = 10;

int to_ms(std::size_t cycle, std::size_t since) {
    return (static_cast<int>(cycle) - static_cast<int>(since)) * cycle_ms;
}

bool is_same_statement(const EcuAnswer& faulty, const EcuAnswer& right) {
    return faulty.state == right.state && faulty.roll_source == right.roll_source &&
           faulty.degradation == right.degradation;
}

bool has_no_further_code(const EcuAnswer& faulty, const EcuAnswer& right) {
    return (faulty.codes & ~right.codes).none();
}

std::optional<std::size_t> first_warning(const FaultyRun& run) {
    for (std::size_t cycle = 0U; cycle < run.answers.size(); ++cycle) {
        if (run.answers[cycle] && run.answers[cycle]->state == WarningState::warning) {
            return cycle;
        }
    }
    return std::nullopt;
}

// While the controller is off the bus the ECU's frames reach no receiver.
bool is_heard(const Fault& fault, const FaultyRun& run, const FaultedDrive& drive, std::size_t cycle) {
    const bool off = fault.kind == FaultKind::bus_off && cycle >= drive.fault_begin && cycle < run.over;
    return run.answers[cycle].has_value() && !off;
}

void keep_first(std::optional<int>& time, bool happened, int now) {
    if (!time && happened) {
        time = now;
    }
}

void measure_warning(const FaultedDrive& drive, const FaultyRun& right, const FaultyRun& faulty,
                     Reaction& reaction) {
    const std::optional<std::size_t> due = first_warning(right);
    if (!due) {
        return;
    }
    const std::optional<std::size_t> came = first_warning(faulty);
    reaction.warning_missed = !came;
    if (came) {
        reaction.lead_loss = to_ms(*came, *due);
        if (drive.two_wheel_lift) {
            reaction.lead = to_ms(*drive.two_wheel_lift, *came);
        }
    }
}

// From the end of the fault to the first cycle from which on `agree` holds; none: not until `end`.
template <typename Agree>
std::optional<int> time_to_agreement(const FaultyRun& right, const FaultyRun& faulty, std::size_t end,
                                     Agree agree) {
    std::size_t since = end;
    while (since > faulty.over && faulty.answers[since - 1U] &&
           agree(*faulty.answers[since - 1U], *right.answers[since - 1U])) {
        --since;
    }
    return since < end ? std::optional<int>{to_ms(since, faulty.over)} : std::nullopt;
}

void measure_recovery(const FaultedDrive& drive, const FaultyRun& right, const FaultyRun& faulty,
                      Reaction& reaction) {
    // With two wheels in the air the vehicle is no longer what the checks know.
    const std::size_t end = drive.two_wheel_lift.value_or(drive.samples.size());
    if (faulty.over >= end) {
        return;
    }
    reaction.watched_ms = to_ms(end, faulty.over);
    const std::optional<std::size_t> due = first_warning(right);
    if (due && *due >= faulty.over) {
        reaction.due = to_ms(*due, faulty.over);
    }
    reaction.recovery = time_to_agreement(right, faulty, end, is_same_statement);
    reaction.healing = time_to_agreement(right, faulty, end, has_no_further_code);
}

}  // namespace

Reaction measure(const FaultedDrive& drive, const Fault& fault, const FaultyRun& right,
                 const FaultyRun& faulty) {
    Reaction reaction;
    reaction.visible = faulty.visible.has_value();
    reaction.watchdog_fed = faulty.watchdog_fed;
    const std::size_t since = faulty.visible.value_or(drive.fault_begin);
    reaction.warning_due = first_warning(right).has_value();
    int silence = 0;
    int wrong = 0;
    int lapse = 0;
    for (std::size_t cycle = drive.fault_begin; cycle < drive.samples.size(); ++cycle) {
        if (!is_heard(fault, faulty, drive, cycle)) {
            continue;
        }
        const EcuAnswer& was = *right.answers[cycle];
        const EcuAnswer& is = *faulty.answers[cycle];
        const DiagnosticCodes new_codes = is.codes & ~was.codes;
        const int now = to_ms(cycle, since);
        keep_first(reaction.unavailable,
                   is.state == WarningState::unavailable && was.state != WarningState::unavailable, now);
        keep_first(reaction.observer,
                   is.roll_source == RollSource::observer && was.roll_source == RollSource::sensor, now);
        keep_first(reaction.motion_lost,
                   is.degradation == Degradation::motion_lost && was.degradation == Degradation::full, now);
        if (!reaction.code && new_codes.any()) {
            reaction.code = now;
            reaction.code_name = diagnostic_names(new_codes).front();
        }
        const bool due = was.state == WarningState::warning;
        silence = due && is.state == WarningState::ready && is.codes.none() ? silence + cycle_ms : 0;
        reaction.silence = std::max(reaction.silence, silence);
        wrong = is.state != was.state && is.codes.none() ? wrong + cycle_ms : 0;
        reaction.wrong = std::max(reaction.wrong, wrong);
        lapse = reaction.code && cycle < faulty.over && new_codes.none() ? lapse + cycle_ms : 0;
        reaction.lapse = std::max(reaction.lapse, lapse);
        reaction.false_warning += !reaction.warning_due && is.state == WarningState::warning ? cycle_ms : 0;
        reaction.incomplete_cycles += is.complete ? 0U : 1U;
        reaction.undefined_cycles += is.defined ? 0U : 1U;
    }
    measure_warning(drive, right, faulty, reaction);
    measure_recovery(drive, right, faulty, reaction);
    return reaction;
}

bool silences_a_warning(const Reaction& reaction) {
    return reaction.silence > longest_silence_ms;
}

Verdict judge(const Expectation& expected, const Reaction& reaction) {
    Verdict verdict;
    const auto demand = [&verdict](bool good, const std::string& otherwise) {
        if (!good) {
            verdict.shortfalls.push_back(otherwise);
        }
    };
    // The effect on the warning of an error that no check detects in time.
    const auto demand_if_seen = [&](bool good, const std::string& otherwise) {
        if (!good) {
            (expected.known_undetected ? verdict.known_undetected : verdict.shortfalls).push_back(otherwise);
        }
    };
    const auto in_time = [&expected](const std::optional<int>& time) {
        return time && *time <= expected.reaction_ms;
    };
    demand(reaction.incomplete_cycles == 0U, "a frame is missing or damaged");
    demand(reaction.undefined_cycles == 0U, "an undefined code on the bus");
    demand(reaction.watchdog_fed, "watchdog");
    demand_if_seen(!silences_a_warning(reaction),
                   fmt::format("silent for {} ms while a warning is due", reaction.silence));
    demand(reaction.false_warning <= longest_false_warning_ms(expected),
           fmt::format("false warning for {} ms", reaction.false_warning));
    const auto come_back = [&reaction](const std::optional<int>& time, int limit_ms) {
        return time ? *time <= limit_ms : reaction.watched_ms < limit_ms;
    };
    // A warning that is due soon after the fault may come as late as it may with the fault.
    const int recovery_ms = reaction.due
                                ? std::max(expected.recovery_ms, *reaction.due + expected.lead_loss_ms)
                                : expected.recovery_ms;
    demand(come_back(reaction.recovery, recovery_ms),
           reaction.recovery ? fmt::format("back after {} ms only", reaction.recovery.value_or(0))
                             : std::string{"does not come back"});
    demand(come_back(reaction.healing, expected.healing_ms),
           reaction.healing ? fmt::format("codes for {} ms more", reaction.healing.value_or(0))
                            : std::string{"codes do not heal"});
    const bool reported = in_time(reaction.code);
    if (expected.demand == Demand::unaffected) {
        demand(!reaction.code && !reaction.unavailable, "a reaction");
    } else if (expected.demand != Demand::right && expected.demand != Demand::recovery && reaction.visible) {
        demand(reported, "no code in time");
        demand(reaction.lapse <= expected.lapse_ms,
               fmt::format("no code for {} ms while the fault is there", reaction.lapse));
    }
    demand_if_seen(reaction.wrong <= expected.wrong_ms,
                   fmt::format("wrong for {} ms without a code", reaction.wrong));
    if (expected.demand == Demand::unavailable && reaction.visible) {
        demand(in_time(reaction.unavailable), "not unavailable in time");
    }
    if (expected.demand == Demand::roll_sensor_lost && reaction.visible) {
        demand(in_time(reaction.observer), "observer not in use in time");
    }
    if (expected.demand == Demand::motion_lost && reaction.visible) {
        demand(in_time(reaction.motion_lost), "not \"motion lost\" in time");
    }
    const bool usable = expected.demand != Demand::unavailable && expected.demand != Demand::reported &&
                        expected.demand != Demand::recovery;
    const bool back_before =
        expected.demand == Demand::recovery && reaction.due.value_or(0) >= expected.recovery_ms;
    demand(!usable || !reaction.unavailable, "unavailable");
    if (usable || back_before) {
        demand_if_seen(!reaction.warning_missed, "no warning");
        demand_if_seen(reaction.lead_loss.value_or(0) <= expected.lead_loss_ms, "warning late");
        demand_if_seen(reaction.lead.value_or(least_lead_ms) >= least_lead_ms,
                       "warning too late before two-wheel lift-off");
    }
    return verdict;
}

}  // namespace sil
