#include "sil/studies/faults/fault_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sil/random.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/studies/faults/judgement.hpp"
#include "sil/studies/faults/sensor_signal.hpp"

namespace sil {
namespace {

constexpr std::size_t most_drives_kept = 8U;
constexpr std::uint64_t scenario_stream = 0x5CE9A710U;  // other random numbers than the drives'

constexpr double share_from_start = 0.3;
constexpr double share_towards_warning = 0.4;
constexpr double longest_before_warning_s = 3.0;
constexpr double share_that_stays = 0.5;
constexpr double shortest_s = 0.05;
constexpr double longest_s = 5.0;

constexpr double share_intermittent = 0.15;
constexpr double shortest_burst_s = 0.02;
constexpr double longest_burst_s = 0.3;
constexpr double longest_period_s = 3.0;

// Factors on the sizes of the matrix.
constexpr double smallest_size = 0.25;
constexpr double largest_size = 8.0;

constexpr double milliseconds_a_cycle = 1.0e3 * cycle_time_s;

double logarithmic(RandomStream& chance, double low, double high) {
    return low * std::pow(high / low, chance.between(0.0, 1.0));
}

// Every kind at every place, once.
const std::vector<Fault>& kinds_at_places() {
    static const std::vector<Fault> all = [] {
        std::vector<Fault> found;
        for (const std::vector<Fault>& faults :
             {all_faults(), further_faults(), mass_faults(), coupled_faults()}) {
            for (const Fault& fault : faults) {
                const bool is_there = std::any_of(found.begin(), found.end(), [&fault](const Fault& each) {
                    return each.kind == fault.kind && each.place == fault.place;
                });
                if (!is_there) {
                    found.push_back(fault);
                }
            }
        }
        return found;
    }();
    return all;
}

double drawn_magnitude(const Fault& fault, RandomStream& chance) {
    switch (fault.kind) {
        case FaultKind::offset:
        case FaultKind::drift:
        case FaultKind::noise:
        case FaultKind::noise_alone:
            return fault.magnitude * logarithmic(chance, smallest_size, largest_size);
        case FaultKind::gain:
            return chance.between(0.0, 1.0) < 0.5 ? chance.between(0.0, 1.0) : chance.between(1.0, 3.0);
        case FaultKind::delayed:
            return std::round(chance.between(1.0, 20.0)) * milliseconds_a_cycle;
        case FaultKind::process_stop:
            return std::round(logarithmic(chance, 1.0, 200.0)) * milliseconds_a_cycle;
        case FaultKind::clock_jump:
            return (chance.below(2U) == 0U ? 1.0 : -1.0) * std::round(logarithmic(chance, 1.0, 2000.0));
        case FaultKind::flood_foreign:
        case FaultKind::flood_own:
            return std::round(logarithmic(chance, 1.0, 150.0));
        default:
            return fault.magnitude;
    }
}

Fault drawn_fault(RandomStream& chance) {
    Fault fault = kinds_at_places()[chance.below(kinds_at_places().size())];
    fault.magnitude = drawn_magnitude(fault, chance);
    const std::vector<Fault> signs = in_each_sign(fault);
    return signs[chance.below(signs.size())];
}

std::size_t drawn_begin(const SearchDrive& drive, RandomStream& chance) {
    const double way = chance.between(0.0, 1.0);
    const double place = chance.between(0.0, 1.0);
    if (way < share_from_start) {
        return 0U;
    }
    if (drive.due && way < share_from_start + share_towards_warning) {
        return *drive.due - std::min(*drive.due, cycle_count(place * longest_before_warning_s));
    }
    return static_cast<std::size_t>(place * static_cast<double>(drive.drive.samples.size()));
}

}  // namespace

struct FaultSearch::Injection {
    std::shared_ptr<const Slot> slot{};
    SearchScenario scenario{};
    FaultedDrive drive{};
    FaultyRun faulty{};

    const SearchDrive& recorded() const { return *slot->drive; }
    const FaultyRun& right() const { return recorded().right.of(scenario.fault); }
    Reaction reaction() const { return measure(drive, scenario.fault, right(), faulty); }
    std::vector<FindingKind> findings() const { return silent_findings(drive, right(), faulty); }
};

SearchScenario FaultSearch::draw(std::uint64_t number, const SearchDrive& drive) const {
    RandomStream chance{scrambled(scrambled(settings().seed ^ scenario_stream) ^ number)};
    SearchScenario scenario;
    scenario.fault = drawn_fault(chance);
    scenario.begin = drawn_begin(drive, chance);
    const bool stays = chance.between(0.0, 1.0) < share_that_stays;
    const std::size_t lasts = cycle_count(logarithmic(chance, shortest_s, longest_s));
    const std::size_t size = drive.drive.samples.size();
    scenario.end = stays ? size : std::min(size, scenario.begin + lasts);
    if (chance.between(0.0, 1.0) < share_intermittent) {
        scenario.burst = cycle_count(logarithmic(chance, shortest_burst_s, longest_burst_s));
        scenario.period =
            scenario.burst + cycle_count(logarithmic(chance, longest_burst_s, longest_period_s));
        scenario.end = size;
    }
    return scenario;
}

std::shared_ptr<const FaultSearch::Slot> FaultSearch::drive_of(std::uint64_t number) const {
    const std::uint64_t drive = number / scenarios_a_drive;
    std::shared_ptr<Slot> slot;
    {
        const std::lock_guard<std::mutex> lock{mutex_};
        std::shared_ptr<Slot>& held = drives_[drive];
        if (!held) {
            held = std::make_shared<Slot>();
        }
        slot = held;
        if (drives_.size() > most_drives_kept) {
            drives_.erase(drives_.begin());
        }
    }
    std::call_once(slot->recorded, [&] {
        slot->drive = std::make_unique<const SearchDrive>(record_search_drive(world_, drive));
    });
    return slot;
}

FaultSearch::Injection FaultSearch::inject(std::uint64_t number) const {
    Injection injection;
    injection.slot = drive_of(number);
    const SearchDrive& recorded = injection.recorded();
    injection.scenario = draw(number, recorded);
    injection.drive = recorded.drive;
    injection.drive.fault_begin = injection.scenario.begin;
    injection.drive.fault_end = injection.scenario.end;
    injection.drive.fault_period = injection.scenario.period;
    injection.drive.fault_burst = injection.scenario.burst;
    injection.faulty = run_with_fault(injection.drive, injection.scenario.fault, recorded.calibration);
    return injection;
}

SearchOutcome FaultSearch::run(std::uint64_t number) const {
    const Injection injection = inject(number);
    const Fault& fault = injection.scenario.fault;
    const Reaction reaction = injection.reaction();
    return {number,
            fault.kind,
            fault.place,
            injection.faulty.visible.has_value(),
            injection.recorded().due.has_value(),
            reaction.code || reaction.unavailable,
            injection.findings()};
}

std::string FaultSearch::explain(std::uint64_t number) const {
    const Injection injection = inject(number);
    const SearchDrive& drive = injection.recorded();
    const SearchScenario& scenario = injection.scenario;
    const auto seconds = [](std::size_t cycle) { return static_cast<double>(cycle) * cycle_time_s; };
    std::string text = fmt::format(
        "Scenario {}: {}, {}, {:.2f} s long{}; the ECU starts {:.2f} s after the drive\n"
        "  {} of {} from {:.2f} to {:.2f} s{}; a warning is due {}\n  reaction, ms: {}\n",
        number, drive.vehicle, drive.name, seconds(injection.drive.samples.size()),
        injection.drive.two_wheel_lift ? ", ends with two-wheel lift-off" : "", drive.ecu_starts_at_s,
        describe(scenario.fault), to_string(scenario.fault.place), seconds(scenario.begin),
        seconds(scenario.end),
        scenario.period > 0U
            ? fmt::format(", for {:.2f} of every {:.2f} s", seconds(scenario.burst), seconds(scenario.period))
            : "",
        drive.due ? fmt::format("at {:.2f} s", seconds(*drive.due)) : "at no time",
        describe({injection.reaction()}));
    for (const FindingKind kind : injection.findings()) {
        text += fmt::format("  {}\n", to_string(kind));
    }
    return text;
}

}  // namespace sil
