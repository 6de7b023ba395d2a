#include "sil/faults/endurance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "sil/faults/chance.hpp"
#include "sil/faults/expectation.hpp"
#include "sil/faults/faulty_bus.hpp"
#include "sil/faults/faulty_ecu.hpp"
#include "sil/faults/faulty_run.hpp"
#include "sil/faults/mixed_driving.hpp"
#include "sil/faults/signal_fault.hpp"
#include "sil/manoeuvres/manoeuvre_run.hpp"
#include "sil/sensors/sensor_suite.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/simulation/sensor_frames.hpp"

namespace sil {
namespace {

constexpr double upset_rad = 1.2;
constexpr std::uint64_t cycles_an_hour = 360000U;
constexpr std::uint64_t cycles_without_vehicle = 100U;
constexpr std::uint64_t settling_cycles = 100U;  // of the first start, before the first fault

// Plant and sensors; a vehicle that has rolled over is replaced by another one.
class World {
 public:
    World(const VehicleParameters& vehicle, std::uint64_t seed, double duration_s)
        : vehicle_{vehicle}, seed_{seed}, duration_s_{duration_s} {
        SensorFlaws flaws;
        flaws.noise = true;
        flaws.seed = seed;
        flaws.bank_sensor = true;
        sensors_.emplace(mounted_sensors(vehicle, flaws));
        start();
    }

    // The next cycle's sample; none while there is no vehicle.
    std::optional<SensorSample> next() {
        if (absent_ > 0U) {
            --absent_;
            return std::nullopt;
        }
        for (int step = 0; step < 10; ++step) {
            plant_->step();
            sensors_->observe(plant_->truth());
        }
        if (std::abs(plant_->truth().roll_angle_rad) > upset_rad) {
            ++rollovers_;
            start();
            absent_ = cycles_without_vehicle;
            return std::nullopt;
        }
        return sensors_->report(plant_->truth());
    }

    std::uint64_t rollovers() const { return rollovers_; }

 private:
    void start() {
        plant_.emplace(vehicle_, mixed_driving(seed_ + 1000U * rollovers_, duration_s_));
        sensors_->observe(plant_->truth());
    }

    const VehicleParameters& vehicle_;
    std::uint64_t seed_;
    double duration_s_;
    std::optional<ManoeuvreRun> plant_{};
    std::optional<SensorSuite> sensors_{};
    std::uint64_t absent_{0U};
    std::uint64_t rollovers_{0U};
};

// One ECU and the way to it.
class Line {
 public:
    explicit Line(const rsi::Parameters& calibration) : ecu_{calibration} { inject(Fault{}); }

    void inject(const Fault& fault) {
        fault_ = fault;
        ecu_.inject(fault);
        bus_ = std::make_unique<FaultyBus>(ecu_.world_bus(), fault);
        sensor_.emplace(fault);
    }

    // None while the ECU's processor stands or nobody hears it.
    std::optional<EcuAnswer> cycle(std::uint64_t number, const std::optional<SensorSample>& sample,
                                   bool active) {
        ecu_.begin_cycle(number, active);
        bus_->begin_cycle(active);
        if (sample) {
            frames_.send(*bus_, sensor_->apply(*sample, active));
        }
        stepped_ = ecu_.step();
        const int feeds = ecu_.watchdog_feeds() - fed_;
        fed_ = ecu_.watchdog_feeds();
        fed_once_ = feeds == (stepped_ ? 1 : 0);
        if (!stepped_ || (active && fault_.kind == FaultKind::bus_off)) {
            return std::nullopt;
        }
        return ear_.listen(ecu_.world_bus());
    }

    bool fed_once() const { return fed_once_; }
    const rsi::Outputs& outputs() const { return ecu_.outputs(); }

 private:
    FaultyEcu ecu_;
    Fault fault_{};
    std::unique_ptr<FaultyBus> bus_{};
    std::optional<SignalFault> sensor_{};
    SensorFrames frames_{};
    EcuEar ear_{};
    int fed_{0};
    bool stepped_{false};
    bool fed_once_{true};
};

// When which fault is there.
class Schedule {
 public:
    explicit Schedule(std::uint64_t seed) : chance_{seed} { draw(settling_cycles); }

    const Fault& fault() const { return fault_; }
    std::uint64_t begin() const { return begin_; }
    bool is_active(std::uint64_t cycle) const { return cycle >= begin_ && cycle < end_; }
    // Of the fault and its consequences: a stopped process goes on later than the fault's end.
    std::uint64_t over() const { return over_; }

    void draw(std::uint64_t from) {
        const std::vector<Fault>& all = all_faults();
        fault_ = all[chance_.below(all.size())];
        begin_ = from + cycles(chance_.between(1.0, 20.0));
        end_ = begin_ + cycles(chance_.between(0.05, 5.0));
        over_ = end_;
        if (fault_.kind == FaultKind::process_stop) {
            over_ = std::max(end_, begin_ + static_cast<std::uint64_t>(fault_.magnitude) / 10U + 1U);
        }
    }

 private:
    static std::uint64_t cycles(double seconds) { return static_cast<std::uint64_t>(seconds * 100.0); }

    Chance chance_;
    Fault fault_{};
    std::uint64_t begin_{0U};
    std::uint64_t end_{0U};
    std::uint64_t over_{0U};
};

bool is_within(float value, double low, double high) {
    const auto number = static_cast<double>(value);
    return number >= low && number <= high;
}

// What could not be computed is NaN.
bool is_within_if_known(float value, double low, double high) {
    return std::isnan(value) || is_within(value, low, high);
}

// Every number NaN or finite; what drives the warning there whenever there is a statement; estimates within
// what the bus can carry.
bool are_good(const rsi::Outputs& outputs) {
    const std::array numbers{
        outputs.rsi,
        outputs.rsi_bank_free,
        outputs.road_parallel_force_mps2,
        outputs.road_normal_force_mps2,
        outputs.fixed_model_roll_angle_rad,
        outputs.compensated_roll_angle_rad,
        outputs.additional_roll_moment_nm,
        outputs.roll_centre_vertical_m,
        outputs.roll_centre_lateral_m,
        outputs.roll_stiffness_deviation_nmprad,
        outputs.roll_damping_deviation_nmsprad,
        outputs.disturbance_nm,
        outputs.roll_centre_deviation_m,
        outputs.observed_roll_angle_rad,
        outputs.observed_bank_angle_rad,
        outputs.rsi_extended,
        outputs.load_transfer_ratio,
        outputs.predicted_load_transfer_ratio,
        outputs.predicted_rsi,
        outputs.static_stability_level,
        outputs.dynamic_stability_index,
        outputs.dynamic_stability_index_late,
        outputs.energy_margin,
        outputs.rollover_index,
        outputs.time_to_rollover_s,
    };
    const bool finite =
        std::none_of(numbers.begin(), numbers.end(), [](float number) { return std::isinf(number); });
    if (outputs.state == RSI_STATE_UNAVAILABLE) {
        return finite;
    }
    return finite && is_within(outputs.warning_level, 0.0, 20.0) &&
           is_within(outputs.lateral_acceleration_mps2, -100.0, 100.0) &&
           is_within_if_known(outputs.roll_centre_deviation_m, 0.0, 0.5) &&
           is_within_if_known(outputs.roll_centre_vertical_m, -1.0, 1.0);
}

// Measures the time from the end of each fault to the agreement of both ECUs, which must last a second: in
// hard driving each may doubt the roll sensor at a moment of its own.
class RecoveryWatch {
 public:
    void begin(std::uint64_t over) {
        over_ = over;
        since_ = over;
        recovered_ = false;
    }
    void cycle(std::uint64_t number, bool agrees) {
        if (recovered_) {
            return;
        }
        if (!agrees || number < over_) {
            since_ = number + 1U;
        }
        recovered_ = number >= std::max(since_, over_) + lasting_cycles;
    }
    bool is_past_limit(std::uint64_t number) const { return number >= over_ + recovery_limit_ms / 10; }
    bool has_recovered() const { return recovered_; }
    int recovery_ms() const { return recovered_ ? static_cast<int>(since_ - over_) * 10 : 0; }

 private:
    static constexpr std::uint64_t lasting_cycles = 100U;

    std::uint64_t over_{0U};
    std::uint64_t since_{0U};
    bool recovered_{false};
};

// Both are usable or not, use the same roll angle, and the faulty one has no code of its own. Which of ready,
// advisory and warning it is may differ for a while near a threshold.
bool agree(const EcuAnswer& faulty, const EcuAnswer& right) {
    return (faulty.state == WarningState::unavailable) == (right.state == WarningState::unavailable) &&
           faulty.roll_source == right.roll_source && faulty.degradation == right.degradation &&
           (faulty.codes & ~right.codes) == 0U;
}

// A warning is due while the second ECU warns and its level may not leave the warning yet. Thereafter it
// merely holds what it has said, and an ECU that could not say it then has nothing to hold.
class SilenceWatch {
 public:
    explicit SilenceWatch(float warning_off) : warning_off_{warning_off} {}

    void cycle(const std::optional<EcuAnswer>& faulty, const EcuAnswer& right, float right_level,
               EnduranceResult& result) {
        const bool warns = right.state == WarningState::warning;
        result.warnings_due += warns && !warned_ ? 1U : 0U;
        warned_ = warns;
        const bool silent = warns && right_level >= warning_off_ && faulty &&
                            faulty->state == WarningState::ready && faulty->codes == 0U;
        silence_ms_ = silent ? silence_ms_ + 10 : 0;
        result.longest_silence_ms = std::max(result.longest_silence_ms, silence_ms_);
        result.warnings_silenced += silence_ms_ == longest_silence_ms + 10 ? 1U : 0U;
    }

 private:
    float warning_off_;
    bool warned_{false};
    int silence_ms_{0};
};

std::string fault_at(std::uint64_t cycle, const Fault& fault) {
    return fmt::format("{} of {}, at {:.0f} s", describe(fault), to_string(fault.place),
                       static_cast<double>(cycle) * cycle_time_s);
}

void watch_outputs(const Line& line, EnduranceResult& result) {
    const rsi::Outputs& outputs = line.outputs();
    result.bad_outputs += are_good(outputs) ? 0U : 1U;
    result.unfed_cycles += line.fed_once() ? 0U : 1U;
    const auto largest = [](double& held, float value) {
        if (std::isfinite(value)) {
            held = std::max(held, static_cast<double>(std::abs(value)));
        }
    };
    largest(result.largest_roll_centre_deviation_m, outputs.roll_centre_deviation_m);
    largest(result.largest_roll_centre_movement_m, outputs.roll_centre_vertical_m);
}

}  // namespace

EnduranceResult run_endurance(const VehicleParameters& vehicle, const rsi::Parameters& calibration,
                              const EnduranceSettings& settings,
                              const std::function<void(double share)>& progress) {
    EnduranceResult result;
    const auto all = static_cast<std::uint64_t>(settings.hours * static_cast<double>(cycles_an_hour));
    World world{vehicle, settings.seed, settings.hours * 3600.0 + 10.0};
    Line faulty{calibration};
    Line right{calibration};
    Schedule schedule{settings.seed};
    RecoveryWatch recovery;
    SilenceWatch silence{calibration.warning_off};
    recovery.begin(schedule.over());
    faulty.inject(schedule.fault());
    for (std::uint64_t cycle = 0U; cycle < all; ++cycle) {
        std::optional<SensorSample> sample = world.next();
        if (sample) {
            sample = as_equipped(*sample, schedule.fault());
        }
        const EcuAnswer expected = *right.cycle(cycle, sample, false);
        const std::optional<EcuAnswer> answer = faulty.cycle(cycle, sample, schedule.is_active(cycle));
        if (answer) {
            result.incomplete_cycles += answer->complete ? 0U : 1U;
            result.undefined_cycles += answer->defined ? 0U : 1U;
        }
        watch_outputs(faulty, result);
        const std::uint64_t silenced = result.warnings_silenced;
        silence.cycle(answer, expected, right.outputs().warning_level, result);
        if (result.warnings_silenced > silenced) {
            result.silenced_by.push_back(fault_at(cycle, schedule.fault()));
        }
        recovery.cycle(cycle, answer && agree(*answer, expected));
        if (recovery.is_past_limit(cycle)) {
            ++result.faults;
            if (!recovery.has_recovered()) {
                result.not_recovered_from.push_back(fault_at(cycle, schedule.fault()));
            }
            result.longest_recovery_ms = std::max(result.longest_recovery_ms, recovery.recovery_ms());
            schedule.draw(cycle);
            faulty.inject(schedule.fault());
            recovery.begin(schedule.over());
        }
        if (progress && cycle % cycles_an_hour == 0U) {
            progress(static_cast<double>(cycle) / static_cast<double>(all));
        }
    }
    result.cycles = all;
    result.rollovers = world.rollovers();
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

std::string endurance_row(const EnduranceSettings& settings, const EnduranceResult& result) {
    return fmt::format(
        "| {:g} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.3f} | {:.3f} |\n", settings.hours,
        settings.seed, result.faults, result.rollovers, result.warnings_due, result.warnings_silenced,
        result.longest_silence_ms, result.incomplete_cycles + result.undefined_cycles + result.unfed_cycles,
        result.bad_outputs,
        result.not_recovered_from.empty() ? fmt::format("{}", result.longest_recovery_ms)
                                          : fmt::format("{} not", result.not_recovered_from.size()),
        result.largest_roll_centre_deviation_m, result.largest_roll_centre_movement_m);
}

std::string endurance_document(const std::string& rows) {
    return "# Endurance: hours of driving with random faults\n\n"
           "Written by `sil/faults/run --endurance`; `tests/run faults` drives the first row again and fails "
           "when a figure differs.\n\n"
           "A simulated large SUV goes straight, turns, changes lanes and weaves by chance, at 30 to 110 "
           "km/h "
           "on a level road, with sensor noise; three in ten turns are\nmeant for 0.5 to 0.9 g. Who rolls "
           "over "
           "gets a new vehicle. Every 11 to 30 s a fault of the [fault matrix](fault_matrix.md), drawn from "
           "all "
           "of them, lasts 0.05 to 5 s.\nOne ECU drives through all of it and is never started anew; a "
           "second "
           "one sees the same drive without faults, and says what would be right.\n\n"
           "| hours | seed | faults | rollovers | warnings due | silenced | longest silence, ms | bad cycles "
           "| "
           "outputs out of range | longest recovery, ms | roll centre: largest deviation, m | largest "
           "movement, m |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|\n" +
           rows +
           "\n- **warnings due**: how often the second ECU came to warn; **silenced**: of these, how often "
           "the "
           "first one was `ready` without any diagnostic code, if only for a cycle, while the level of the "
           "second\n  was not below `warning_off` (below that it merely holds its warning for two seconds); "
           "**longest silence**: the longest such time.\n"
           "- **bad cycles**: a frame is missing or damaged, a code is on the bus that the DBC file does not "
           "define, or the watchdog was not fed once.\n"
           "- **outputs out of range**: cycles in which an output is infinite, or one that is needed for the "
           "statement is not a number, or an estimate is beyond what the bus can carry.\n"
           "- **longest recovery**: from the end of a fault until availability, degradation and roll source "
           "are "
           "those of the second ECU and no further code is left, for a second.\n  More than 10,000 ms would "
           "count as stuck (\"not\").\n"
           "- **roll centre**: the largest standard deviation that the estimator gave itself, and the "
           "largest "
           "vertical movement that it estimated: its covariance stays bounded.\n\n"
           "The firmware has no heap (`tests/run application`), so its memory cannot grow.\n";
}

}  // namespace sil
