#include "sil/studies/faults/endurance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "rsi/output_table.hpp"
#include "rsi/types.hpp"
#include "sil/studies/faults/expectation.hpp"
#include "sil/studies/faults/fault_schedule.hpp"
#include "sil/studies/faults/faulty_line.hpp"
#include "sil/studies/faults/faulty_run.hpp"
#include "sil/studies/faults/known_undetected.hpp"
#include "sil/studies/faults/lookahead_window.hpp"
#include "sil/studies/faults/recovery_watch.hpp"
#include "sil/studies/faults/silence_watch.hpp"

namespace sil {
namespace {

bool is_within(float value, double low, double high) {
    const auto number = static_cast<double>(value);
    return number >= low && number <= high;
}

// A value that could not be computed is NaN.
bool is_within_if_known(float value, double low, double high) {
    return std::isnan(value) || is_within(value, low, high);
}

// Every number NaN or finite; what drives the warning there whenever there is a statement; estimates within
// what the bus can carry.
bool are_in_range(const rsi::Outputs& outputs) {
    const bool finite = std::none_of(
        rsi::number_outputs.begin(), rsi::number_outputs.end(),
        [&outputs](const rsi::NumberOutput& number) { return std::isinf(outputs.*number.member); });
    if (outputs.state == RSI_STATE_UNAVAILABLE) {
        return finite;
    }
    return finite && is_within(outputs.warning_level, 0.0, 20.0) &&
           is_within(outputs.lateral_acceleration_mps2, -100.0, 100.0) &&
           is_within_if_known(outputs.roll_centre_deviation_m, 0.0, 0.5) &&
           is_within_if_known(outputs.roll_centre_vertical_m, -1.0, 1.0);
}

constexpr std::uint64_t cycles_an_hour = 360000U;
constexpr std::uint64_t settling_cycles = 100U;  // of the first start, before the first fault

// Both are usable or not, use the same roll angle, and the faulty one has no code of its own. Which of ready,
// advisory and warning it is may differ for a while near a threshold.
bool agree(const EcuAnswer& faulty, const EcuAnswer& right) {
    return (faulty.state == WarningState::unavailable) == (right.state == WarningState::unavailable) &&
           faulty.roll_source == right.roll_source && faulty.degradation == right.degradation &&
           (faulty.codes & ~right.codes).none();
}

std::string faults_at(std::uint64_t cycle, const FaultSchedule& schedule) {
    std::string text;
    for (const ScheduledFault& each : schedule.faults()) {
        if (each.fault.kind != FaultKind::none) {
            text += fmt::format("{} of {} from {:.2f} to {:.2f} s, ", describe(each.fault),
                                to_string(each.fault.place), static_cast<double>(each.begin) * cycle_time_s,
                                static_cast<double>(each.end) * cycle_time_s);
        }
    }
    return fmt::format("{}at {:.2f} s", text, static_cast<double>(cycle) * cycle_time_s);
}

// Errors of a turn to this side that no check detects in time.
bool is_any_known_undetected(const FaultSchedule& schedule, WarningSide side) {
    return std::any_of(
        schedule.faults().begin(), schedule.faults().end(), [side](const ScheduledFault& each) {
            return is_known_undetected(side == WarningSide::right ? each.fault
                                                                  : in_turn_to_the_other_side(each.fault));
        });
}

void watch_outputs(const FaultyLine& line, EnduranceResult& result) {
    const rsi::Outputs& outputs = line.outputs();
    result.bad_outputs += are_in_range(outputs) ? 0U : 1U;
    result.unfed_cycles += line.fed_once() ? 0U : 1U;
    const auto largest = [](double& held, float value) {
        if (std::isfinite(value)) {
            held = std::max(held, static_cast<double>(std::abs(value)));
        }
    };
    largest(result.largest_roll_centre_deviation_m, outputs.roll_centre_deviation_m);
    largest(result.largest_roll_centre_movement_m, outputs.roll_centre_vertical_m);
}

// A bank sensor when one of the faults is of it.
SensorSample equipped_for(const SensorSample& sample, const FaultSchedule& schedule) {
    const auto& [first, second] = schedule.faults();
    return as_equipped(sample, second.fault.place == FaultPlace::bank_angle ? second.fault : first.fault);
}

// Differences that remain in the ECU's answer.
std::string difference(const std::optional<EcuAnswer>& faulty, const EcuAnswer& right) {
    if (!faulty) {
        return "nothing is heard";
    }
    return fmt::format("degradation {} instead of {}, roll source {} instead of {}, codes: {}",
                       static_cast<int>(faulty->degradation), static_cast<int>(right.degradation),
                       static_cast<int>(faulty->roll_source), static_cast<int>(right.roll_source),
                       fmt::join(diagnostic_names(faulty->codes & ~right.codes), ", "));
}

void count_recovery(const RecoveryWatch& recovery, const std::string& faults, const std::string& otherwise,
                    EnduranceResult& result) {
    ++result.faults;
    if (!recovery.has_recovered()) {
        result.not_recovered_from.push_back(fmt::format("{} ({})", faults, otherwise));
    }
    if (recovery.has_recovered()) {
        result.longest_recovery_ms = std::max(result.longest_recovery_ms, recovery.driven_ms());
    }
    result.over_at_standstill += recovery.was_over_at_standstill() ? 1U : 0U;
    result.recovered_at_standstill += recovery.has_recovered_at_standstill() ? 1U : 0U;
}

}  // namespace

EnduranceResult run_endurance(const VehicleParameters& vehicle, const rsi::Parameters& calibration,
                              const EnduranceSettings& settings,
                              const std::function<void(double share)>& progress) {
    EnduranceResult result;
    const auto all = static_cast<std::uint64_t>(settings.hours * static_cast<double>(cycles_an_hour));
    LookaheadWindow drive{vehicle, calibration, settings.seed, settings.hours * 3600.0 + 20.0};
    FaultyLine faulty{calibration};
    FaultyLine right{calibration};
    FaultSchedule schedule{settings.seed};
    RecoveryWatch recovery;
    SilenceWatch silence{calibration.warning_off};
    const auto begin_next = [&] {
        faulty.inject(schedule.faults());
        recovery.begin(schedule.over());
    };
    schedule.draw(settling_cycles);
    begin_next();
    for (std::uint64_t cycle = 0U; cycle < all; ++cycle) {
        auto [sample, stands] = drive.next();
        if (drive.warning_begins() && schedule.draw_towards(cycle + LookaheadWindow::cycles_ahead, cycle)) {
            begin_next();
        }
        if (sample) {
            sample = equipped_for(*sample, schedule);
        }
        const EcuAnswer expected = *right.cycle(cycle, sample);
        const std::optional<EcuAnswer> answer = faulty.cycle(cycle, sample);
        if (answer) {
            result.incomplete_cycles += answer->complete ? 0U : 1U;
            result.undefined_cycles += answer->defined ? 0U : 1U;
        }
        watch_outputs(faulty, result);
        if (silence.cycle(answer, expected, right.outputs().warning_level, schedule.is_near(cycle), result)) {
            const bool known_undetected = is_any_known_undetected(schedule, expected.side);
            (known_undetected ? result.silenced_known_undetected : result.silenced_by)
                .push_back(faults_at(cycle, schedule));
        }
        recovery.cycle(cycle, answer && agree(*answer, expected), stands);
        if (recovery.has_recovered() || recovery.is_past_limit()) {
            count_recovery(recovery, faults_at(cycle, schedule), difference(answer, expected), result);
            result.pairs += schedule.has_two() ? 1U : 0U;
            schedule.draw(cycle);
            begin_next();
        }
        if (progress && cycle % cycles_an_hour == 0U) {
            progress(static_cast<double>(cycle) / static_cast<double>(all));
        }
    }
    result.cycles = all;
    result.rollovers = drive.world().rollovers();
    result.stops = drive.world().stops();
    return result;
}

std::vector<std::string> shortfalls(const EnduranceResult& result) {
    std::vector<std::string> found;
    const auto none = [&found](std::uint64_t count, const char* what) {
        if (count > 0U) {
            found.push_back(fmt::format("{}: {}", what, count));
        }
    };
    none(result.incomplete_cycles, "cycles without one of the ECU's frames");
    none(result.undefined_cycles, "cycles with an undefined code on the bus");
    none(result.bad_outputs, "cycles with an output out of its range");
    none(result.unfed_cycles, "cycles in which the watchdog was not fed once");
    for (const std::string& fault : result.silenced_by) {
        found.push_back("a due warning was \"ready\" without a code: " + fault);
    }
    for (const std::string& fault : result.not_recovered_from) {
        found.push_back("the ECU did not come back within 10 s of the fault: " + fault);
    }
    return found;
}

}  // namespace sil
