#include "sil/faults/endurance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>

#include "sil/faults/driven_world.hpp"
#include "sil/faults/expectation.hpp"
#include "sil/faults/fault_schedule.hpp"
#include "sil/faults/faulty_bus.hpp"
#include "sil/faults/faulty_ecu.hpp"
#include "sil/faults/faulty_run.hpp"
#include "sil/faults/signal_fault.hpp"
#include "sil/faults/unseen.hpp"
#include "sil/simulation/sensor_frames.hpp"

namespace sil {
namespace {

constexpr std::uint64_t cycles_an_hour = 360000U;
constexpr std::uint64_t settling_cycles = 100U;  // of the first start, before the first fault

// One ECU and the way to it, on which two faults can be.
class Line {
 public:
    explicit Line(const rsi::Parameters& calibration) : ecu_{calibration} { inject({}); }

    void inject(const std::array<ScheduledFault, 2U>& faults) {
        faults_ = faults;
        ecu_.inject(faults_[0].fault);
        first_.reset();  // before what it sends on
        second_ = std::make_unique<FaultyBus>(ecu_.world_bus(), faults_[1].fault);
        first_ = std::make_unique<FaultyBus>(*second_, faults_[0].fault);
        for (std::size_t index = 0U; index < sensors_.size(); ++index) {
            sensors_[index].emplace(faults_[index].fault);
        }
    }

    // None while the ECU's processor stands or nobody hears it.
    std::optional<EcuAnswer> cycle(std::uint64_t number, const std::optional<SensorSample>& sample) {
        const bool first = faults_[0].is_active(number);
        const bool second = faults_[1].is_active(number);
        ecu_.begin_cycle(number, first);
        second_->begin_cycle(second);
        first_->begin_cycle(first);
        if (sample) {
            frames_.send(*first_, sensors_[1]->apply(sensors_[0]->apply(*sample, first), second));
        }
        stepped_ = ecu_.step();
        const int feeds = ecu_.watchdog_feeds() - fed_;
        fed_ = ecu_.watchdog_feeds();
        fed_once_ = feeds == (stepped_ ? 1 : 0);
        if (!stepped_ || (first && faults_[0].fault.kind == FaultKind::bus_off)) {
            return std::nullopt;
        }
        return ear_.listen(ecu_.world_bus());
    }

    bool fed_once() const { return fed_once_; }
    const rsi::Outputs& outputs() const { return ecu_.outputs(); }

 private:
    FaultyEcu ecu_;
    std::array<ScheduledFault, 2U> faults_{};
    std::unique_ptr<FaultyBus> second_{};
    std::unique_ptr<FaultyBus> first_{};
    std::array<std::optional<SignalFault>, 2U> sensors_{};
    SensorFrames frames_{};
    EcuEar ear_{};
    int fed_{0};
    bool stepped_{false};
    bool fed_once_{true};
};

// The drive some seconds ahead of itself, so that faults can be drawn to where a warning will be due. The
// ECUs only warn, so the drive does not depend on them.
class Outlook {
 public:
    struct Cycle {
        std::optional<SensorSample> sample{};
        bool stands{false};
    };

    Outlook(const VehicleParameters& vehicle, const rsi::Parameters& calibration, std::uint64_t seed,
            double duration_s)
        : world_{vehicle, seed, duration_s}, scout_{calibration} {
        while (ahead_.size() < cycles_ahead) {
            look();
        }
    }

    Cycle next() {
        look();
        const Cycle cycle = ahead_.front();
        ahead_.pop_front();
        return cycle;
    }

    // Of the cycle that was seen last.
    bool warning_begins() const { return warning_begins_; }
    const DrivenWorld& world() const { return world_; }

    static constexpr std::uint64_t cycles_ahead = 600U;

 private:
    void look() {
        Cycle cycle{world_.next(), world_.stands()};
        std::optional<SensorSample> seen = cycle.sample;
        if (seen) {
            seen = as_equipped(*seen, Fault{});
        }
        const bool warns = scout_.cycle(number_, seen)->state == WarningState::warning;
        warning_begins_ = warns && !warned_;
        warned_ = warns;
        ++number_;
        ahead_.push_back(cycle);
    }

    DrivenWorld world_;
    Line scout_;
    std::deque<Cycle> ahead_{};
    std::uint64_t number_{0U};
    bool warned_{false};
    bool warning_begins_{false};
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
// hard driving each may doubt the roll sensor at a moment of its own. Time at a standstill counts apart:
// where nothing moves, some values cannot prove themselves.
class RecoveryWatch {
 public:
    void begin(std::uint64_t over) {
        *this = RecoveryWatch{};
        over_ = over;
        since_ = over;
    }
    void cycle(std::uint64_t number, bool agrees, bool stands) {
        if (recovered_ || number < over_) {
            return;
        }
        over_at_standstill_ = over_at_standstill_ || (number == over_ && stands);
        driven_ += stands ? 0U : 1U;
        if (!agrees) {
            since_ = number + 1U;
            driven_since_ = driven_;
        }
        recovered_ = number >= since_ + lasting_cycles;
        recovered_standing_ = recovered_ && stands && driven_ == 0U;
    }
    // Ten seconds of driving.
    bool is_past_limit() const { return driven_ >= recovery_limit_ms / 10; }
    bool has_recovered() const { return recovered_; }
    bool was_over_at_standstill() const { return over_at_standstill_; }
    bool has_recovered_at_standstill() const { return recovered_standing_; }
    int driven_ms() const { return static_cast<int>(driven_since_) * 10; }

 private:
    static constexpr std::uint64_t lasting_cycles = 100U;

    std::uint64_t over_{0U};
    std::uint64_t since_{0U};
    std::uint64_t driven_{0U};
    std::uint64_t driven_since_{0U};
    bool recovered_{false};
    bool over_at_standstill_{false};
    bool recovered_standing_{false};
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

    // `near`: a fault is there, or was within the last two seconds. True in the first cycle of a silence.
    bool cycle(const std::optional<EcuAnswer>& faulty, const EcuAnswer& right, float right_level, bool near,
               EnduranceResult& result) {
        const bool warns = right.state == WarningState::warning;
        if (warns && !warned_) {
            ++result.warnings_due;
            with_fault_ = answered_ = told_ = silent_ = false;
        }
        if (!warns && warned_) {
            count(result);
        }
        warned_ = warns;
        const bool due = warns && right_level >= warning_off_;
        with_fault_ = with_fault_ || (due && near);
        answered_ = answered_ || (due && faulty && faulty->state == WarningState::warning);
        told_ =
            told_ || (due && faulty && (faulty->state == WarningState::unavailable || faulty->codes != 0U));
        const bool is_silent = due && faulty && faulty->state == WarningState::ready && faulty->codes == 0U;
        silence_ms_ = is_silent ? silence_ms_ + 10 : 0;
        result.longest_silence_ms = std::max(result.longest_silence_ms, silence_ms_);
        const bool first = is_silent && !silent_;
        silent_ = silent_ || is_silent;
        return first;
    }

 private:
    void count(EnduranceResult& result) const {
        if (!with_fault_) {
            return;
        }
        ++result.due_with_fault;
        if (silent_) {
            ++result.due_with_fault_silenced;
        } else if (answered_) {
            ++result.due_with_fault_warned;
        } else if (told_) {
            ++result.due_with_fault_told;
        }
    }

    float warning_off_;
    bool warned_{false};
    bool with_fault_{false};
    bool answered_{false};
    bool told_{false};
    bool silent_{false};
    int silence_ms_{0};
};

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

// Of errors that no check sees in time those of a turn to this side.
bool is_any_unseen(const FaultSchedule& schedule, WarningSide side) {
    return std::any_of(
        schedule.faults().begin(), schedule.faults().end(), [side](const ScheduledFault& each) {
            return is_unseen(side == WarningSide::right ? each.fault : in_turn_to_the_other_side(each.fault));
        });
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

// A bank sensor when one of the faults is of it.
SensorSample equipped_for(const SensorSample& sample, const FaultSchedule& schedule) {
    const auto& [first, second] = schedule.faults();
    return as_equipped(sample, second.fault.place == FaultPlace::bank_angle ? second.fault : first.fault);
}

// What the ECU still says otherwise.
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
    Outlook drive{vehicle, calibration, settings.seed, settings.hours * 3600.0 + 20.0};
    Line faulty{calibration};
    Line right{calibration};
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
        if (drive.warning_begins() && schedule.draw_towards(cycle + Outlook::cycles_ahead, cycle)) {
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
            const bool unseen = is_any_unseen(schedule, expected.side);
            (unseen ? result.silenced_unseen : result.silenced_by).push_back(faults_at(cycle, schedule));
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
