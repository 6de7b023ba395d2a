#include "sil/studies/faults/finding.hpp"

#include <algorithm>
#include <array>

#include "sil/studies/faults/expectation.hpp"

namespace sil {
namespace {

constexpr std::size_t ms_a_cycle = 10U;
constexpr std::size_t lead_cycles = least_lead_ms / ms_a_cycle;
constexpr std::size_t lead_loss_cycles = longest_lead_loss_ms / ms_a_cycle;
constexpr std::size_t nearby_cycles = warning_nearby_ms / ms_a_cycle;
constexpr std::size_t cycles_until_a_sender_counts = second_sender_shows_ms / ms_a_cycle;
constexpr std::size_t start_cycles = start_ms / ms_a_cycle;
constexpr double weak_gain = 0.5;

bool warns(const std::optional<EcuAnswer>& answer, WarningSide side) {
    return answer && answer->state == WarningState::warning && answer->side == side;
}

bool tells_a_code(const EcuAnswer& faulty, const EcuAnswer& right) {
    return (faulty.codes & ~right.codes).any();
}

// More than the ECU without the fault says, or nothing at all, which the receiver takes for unavailable.
bool tells(const std::optional<EcuAnswer>& faulty, const EcuAnswer& right) {
    return !faulty || tells_a_code(*faulty, right) ||
           (faulty->state == WarningState::unavailable && right.state != WarningState::unavailable);
}

// Events after two wheels have lifted do not count.
std::size_t end_of(const FaultedDrive& drive) {
    return drive.two_wheel_lift.value_or(drive.samples.size());
}

// A warning that itself comes late may come a little later with the fault.
std::size_t latest_cycle_of_warning(const FaultyRun& right, std::size_t lift, WarningSide side) {
    std::size_t due = lift;
    while (due > 0U && warns(right.answers[due - 1U], side)) {
        --due;
    }
    return std::min(lift, std::max(lift - std::min(lift, lead_cycles), due + lead_loss_cycles));
}

bool misses_a_warning(const FaultedDrive& drive, const FaultyRun& right, const FaultyRun& faulty) {
    if (!drive.two_wheel_lift) {
        return false;
    }
    const EcuAnswer& at_lift = *right.answers[*drive.two_wheel_lift];
    const std::size_t latest = latest_cycle_of_warning(right, *drive.two_wheel_lift, at_lift.side);
    return at_lift.state == WarningState::warning && !warns(faulty.answers[latest], at_lift.side) &&
           !tells(faulty.answers[latest], *right.answers[latest]);
}

bool is_large_towards(WarningSide side, double load_transfer) {
    return (side == WarningSide::right ? load_transfer : -load_transfer) >= large_load_transfer;
}

// True where a warning for that side is near, or a reason for one.
std::vector<bool> near_a_warning(const FaultedDrive& drive, const FaultyRun& right, WarningSide side) {
    const std::size_t size = right.answers.size();
    std::vector<bool> near(size, false);
    std::size_t filled = 0U;
    for (std::size_t cycle = 0U; cycle < size; ++cycle) {
        if (!warns(right.answers[cycle], side) && !is_large_towards(side, drive.load_transfer[cycle])) {
            continue;
        }
        const std::size_t begin = cycle - std::min(cycle, nearby_cycles);
        const std::size_t end = std::min(size, cycle + nearby_cycles + 1U);
        for (filled = std::max(filled, begin); filled < end; ++filled) {
            near[filled] = true;
        }
    }
    return near;
}

bool warns_falsely(const FaultedDrive& drive, const FaultyRun& right, const FaultyRun& faulty,
                   WarningSide side) {
    constexpr int longest = longest_false_warning_without_code_ms / static_cast<int>(ms_a_cycle);
    const std::vector<bool> near = near_a_warning(drive, right, side);
    int lasting = 0;
    for (std::size_t cycle = 0U; cycle < end_of(drive); ++cycle) {
        const bool is_false = warns(faulty.answers[cycle], side) && !near[cycle] &&
                              !tells(faulty.answers[cycle], *right.answers[cycle]);
        lasting = is_false ? lasting + 1 : 0;
        if (lasting > longest) {
            return true;
        }
    }
    return false;
}

bool is_dead_or_weak(const Fault& fault) {
    return fault.place == FaultPlace::lateral_acceleration &&
           (fault.kind == FaultKind::noise_alone ||
            (fault.kind == FaultKind::gain && fault.magnitude <= weak_gain));
}

bool is_reported(const FaultyRun& right, const FaultyRun& faulty, std::size_t begin, std::size_t end) {
    for (std::size_t cycle = begin; cycle < end; ++cycle) {
        if (tells(faulty.answers[cycle], *right.answers[cycle])) {
            return true;
        }
    }
    return false;
}

bool sets_codes_of_good_sensors(const FaultyRun& right, const FaultyRun& other, std::size_t end) {
    const std::size_t started = std::min(start_cycles, end);
    for (std::size_t cycle = 0U; cycle < started; ++cycle) {
        if (other.answers[cycle] && tells_a_code(*other.answers[cycle], *right.answers[cycle])) {
            return true;
        }
    }
    return is_reported(right, other, started, end);
}

bool is_as_demanded(const EcuAnswer& answer, Demand demand) {
    switch (demand) {
        case Demand::unavailable:
            return answer.state == WarningState::unavailable;
        case Demand::roll_sensor_lost:
            return answer.degradation == Degradation::roll_sensor_lost ||
                   answer.degradation == Degradation::unavailable;
        case Demand::motion_lost:
            return answer.degradation == Degradation::motion_lost ||
                   answer.degradation == Degradation::unavailable;
        default:
            return answer.codes.any();
    }
}

bool accepts_second_sender(const FaultedDrive& drive, const Fault& fault, const FaultyRun& faulty) {
    const Demand demand = expectation_of(fault, SceneKind::turn).demand;
    const std::size_t end = std::min(drive.fault_end, end_of(drive));
    for (std::size_t cycle = drive.fault_begin + cycles_until_a_sender_counts; cycle < end; ++cycle) {
        if (faulty.answers[cycle] && !is_as_demanded(*faulty.answers[cycle], demand)) {
            return true;
        }
    }
    return false;
}

}  // namespace

const char* to_string(FindingKind kind) {
    constexpr std::array names{"missed warning", "false warning", "not found", "second sender accepted",
                               "good sensor with a code"};
    return names[static_cast<std::size_t>(kind)];
}

std::vector<FindingKind> silent_findings(const FaultedDrive& drive, const FaultyRun& right,
                                         const FaultyRun& faulty) {
    std::vector<FindingKind> found;
    if (misses_a_warning(drive, right, faulty)) {
        found.push_back(FindingKind::missed_warning);
    }
    if (warns_falsely(drive, right, faulty, WarningSide::left) ||
        warns_falsely(drive, right, faulty, WarningSide::right)) {
        found.push_back(FindingKind::false_warning);
    }
    return found;
}

std::vector<FindingKind> findings_of(const FaultedDrive& drive, const Fault& fault, const FaultyRun& right,
                                     const FaultyRun& faulty, std::size_t ordinary_end) {
    std::vector<FindingKind> found = silent_findings(drive, right, faulty);
    if (ordinary_end > 0U && is_dead_or_weak(fault) &&
        !is_reported(right, faulty, drive.fault_begin, ordinary_end)) {
        found.push_back(FindingKind::not_found);
    }
    if (is_second_sender(fault.kind) && accepts_second_sender(drive, fault, faulty)) {
        found.push_back(FindingKind::second_sender_accepted);
    }
    return found;
}

std::vector<FindingKind> findings_of_good_sensors(const FaultedDrive& drive, const FaultyRun& right,
                                                  const FaultyRun& other) {
    std::vector<FindingKind> found = silent_findings(drive, right, other);
    if (sets_codes_of_good_sensors(right, other, end_of(drive))) {
        found.push_back(FindingKind::good_sensor_with_code);
    }
    return found;
}

}  // namespace sil
