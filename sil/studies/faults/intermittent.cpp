#include "sil/studies/faults/intermittent.hpp"

#include <algorithm>
#include <array>

#include "sil/studies/faults/faulty_run.hpp"
#include "sil/studies/faults/sensor_signal.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/everyday_turns.hpp"

namespace sil {
namespace {

constexpr double drive_s = 70.0;  // two periods of the longest and some seconds
constexpr double first_burst_s = 4.0;
constexpr int ms_a_cycle = 10;

constexpr std::array bursts_ms{20, 50, 100, 200, 300};
constexpr std::array periods_ms{0, 300, 1000, 3000, 10000, 30000};
constexpr std::array offset_shares{1.0, 2.0, 4.0};  // of the matrix' offset

// Slowly enough to be everyday driving: no warning is due.
Manoeuvre everyday(const char* name) {
    Manoeuvre manoeuvre = std::string{name} == "turns" ? gentle_turns(drive_s) : find_manoeuvre(name);
    manoeuvre.name = name;
    manoeuvre.duration_s = drive_s;
    return manoeuvre;
}

std::vector<Fault> faults_of(const SensorSignal& signal) {
    std::vector<Fault> faults{{FaultKind::not_available, signal.place, 0.0}};
    for (const double share : offset_shares) {
        faults.push_back({FaultKind::offset, signal.place, share * signal.offset * signal.unit_si});
    }
    faults.push_back({FaultKind::saturated, signal.place, 1.0});
    return faults;
}

std::vector<Fault> all_bursts() {
    std::vector<std::vector<Fault>> lists;
    for (const SensorSignal& signal : sensor_signals) {
        lists.push_back(faults_of(signal));
    }
    lists.push_back(mass_faults());
    lists.push_back(coupled_faults());
    std::vector<Fault> all;
    for (const std::vector<Fault>& faults : lists) {
        for (const Fault& fault : faults) {
            const std::vector<Fault> signs = in_each_sign(fault);
            all.insert(all.end(), signs.begin(), signs.end());
        }
    }
    return all;
}

struct Planned {
    std::size_t world{0U};
    Fault fault{};
    int burst{0};
    int period{0};
};

void plan(std::size_t world, const Fault& fault, std::vector<Planned>& all) {
    for (const int burst : bursts_ms) {
        for (const int period : periods_ms) {
            if (period != burst) {  // it would be there all the time
                all.push_back({world, fault, burst, period});
            }
        }
    }
}

struct World {
    const IntermittentVehicle* vehicle;
    std::string name;
    FaultedDrive drive;
    RightRuns right;
};

IntermittentRun inject(const World& world, const Planned& planned) {
    FaultedDrive drive = world.drive;
    drive.fault_begin = cycle_count(first_burst_s);
    drive.fault_end = drive.samples.size();
    drive.fault_burst = static_cast<std::size_t>(planned.burst / ms_a_cycle);
    if (planned.period > 0) {
        drive.fault_period = static_cast<std::size_t>(planned.period / ms_a_cycle);
    } else {
        drive.fault_end = drive.fault_begin + drive.fault_burst;
    }
    const FaultyRun& right = world.right.of(planned.fault);
    const FaultyRun faulty = run_with_fault(drive, planned.fault, world.vehicle->calibration);
    IntermittentRun run{
        world.vehicle->name, world.name, planned.fault, planned.burst, planned.period, 0, 0, {}};
    const std::size_t third = drive.fault_begin + 2U * drive.fault_period;
    for (std::size_t cycle = drive.fault_begin; cycle < drive.samples.size(); ++cycle) {
        const EcuAnswer& was = *right.answers[cycle];
        const EcuAnswer& is = *faulty.answers[cycle];
        if (!run.code_ms && (is.codes & ~was.codes).any()) {
            run.code_ms = std::max(0, (static_cast<int>(cycle) - static_cast<int>(third)) * ms_a_cycle);
        }
        if (is.state == WarningState::warning && was.state != WarningState::warning) {
            run.false_warning_ms += ms_a_cycle;
            run.without_code_ms += run.code_ms ? 0 : ms_a_cycle;
        }
    }
    return run;
}

}  // namespace

std::vector<IntermittentRun> run_intermittent_faults(const std::vector<IntermittentVehicle>& vehicles,
                                                     std::size_t most_runs,
                                                     const std::function<void(double share)>& progress) {
    std::vector<World> worlds;
    std::vector<Planned> all;
    for (const IntermittentVehicle& vehicle : vehicles) {
        for (const char* const name : {"straight", "turns"}) {
            FaultedDrive drive;
            static_cast<RecordedDrive&>(drive) =
                record_drive(vehicle.vehicle, everyday(name), {}, {recording_sensors(vehicle.vehicle)})
                    .front();
            drive.fault_end = drive.samples.size();
            worlds.push_back({&vehicle, name, drive, RightRuns{drive, vehicle.calibration}});
            for (const Fault& fault : all_bursts()) {
                plan(worlds.size() - 1U, fault, all);
            }
        }
    }
    const std::size_t count = most_runs == 0U ? all.size() : std::min(most_runs, all.size());
    std::vector<IntermittentRun> runs;
    for (std::size_t index = 0U; index < count; ++index) {
        const Planned& planned = all[index * all.size() / count];
        runs.push_back(inject(worlds[planned.world], planned));
        if (index % 100U == 0U) {
            progress(static_cast<double>(index) / static_cast<double>(count));
        }
    }
    return runs;
}

}  // namespace sil
