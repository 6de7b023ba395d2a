#include "rsi/ecu/application/rollover_ecu.hpp"

#include "rsi/ecu/monitoring/output_check.hpp"
#include "rsi/hal/saturating_count.hpp"

namespace rsi::application {
namespace {

constexpr std::uint32_t most_missed_cycles = 2U;

// Time for sensors to start (1 s): until then a frame that has never been received sets no code.
constexpr std::uint32_t start_cycles = 100U;

constexpr monitoring::CodeSet of_rare_faults = monitoring::set_of(
    monitoring::DiagnosticCode::imu_two_senders, monitoring::DiagnosticCode::roll_angle_two_senders,
    monitoring::DiagnosticCode::vehicle_motion_two_senders,
    monitoring::DiagnosticCode::own_identifier_received, monitoring::DiagnosticCode::imu_held_back,
    monitoring::DiagnosticCode::stored_parameters_refused, monitoring::DiagnosticCode::storage_failed);

// Checks that need a bus that takes frames, and outputs that have been computed.
constexpr monitoring::CodeSet of_a_good_bus = monitoring::set_of(
    monitoring::DiagnosticCode::receive_overflow, monitoring::DiagnosticCode::own_identifier_received);
constexpr monitoring::CodeSet of_outputs = monitoring::set_of(
    monitoring::DiagnosticCode::estimate_out_of_range, monitoring::DiagnosticCode::output_not_finite);

// A sensor that is not fitted is never fresh.
monitoring::CodeSet tested_by(const ReceptionReport& reception) {
    using monitoring::DiagnosticCode;
    using monitoring::set_of;
    constexpr monitoring::CodeSet of_imu =
        set_of(DiagnosticCode::imu_lost, DiagnosticCode::imu_damaged, DiagnosticCode::imu_two_senders);
    constexpr monitoring::CodeSet of_roll_angle =
        set_of(DiagnosticCode::roll_angle_lost, DiagnosticCode::roll_angle_damaged,
               DiagnosticCode::roll_angle_two_senders);
    constexpr monitoring::CodeSet of_vehicle_motion =
        set_of(DiagnosticCode::vehicle_motion_lost, DiagnosticCode::vehicle_motion_damaged,
               DiagnosticCode::vehicle_motion_two_senders);
    const bool has_imu = reception.imu.is_fresh();
    const bool has_roll_angle = reception.roll_angle.is_fresh();
    monitoring::CodeSet tested = 0U;
    tested |= has_imu ? of_imu : 0U;
    tested |= has_roll_angle ? of_roll_angle : 0U;
    tested |= reception.vehicle_motion.is_fresh() ? of_vehicle_motion : 0U;
    // The one is held against the other.
    tested |= (has_imu && has_roll_angle) ? set_of(DiagnosticCode::imu_held_back) : 0U;
    return tested;
}

// True when `count` is not what it was at the last call.
bool has_changed(std::uint32_t count, std::uint32_t& previous) {
    const bool changed = (count != previous);
    previous = count;
    return changed;
}

}  // namespace

rsi::Validation RolloverEcu::init(const rsi::Parameters& parameters) noexcept {
    const rsi::Validation answer = component_.init(parameters);
    parameters_ = (answer.accepted != 0) ? parameters : rsi::Parameters{};
    calibration_.name = {};
    start_checks();
    refusal_ = (answer.accepted != 0) ? ParametersRefusal::none : ParametersRefusal::value;
    protection_ = has_test_keys_ ? Protection::unsealed_test_keys : Protection::unsealed;
    return answer;
}

ParameterSectionAnswer RolloverEcu::init(const std::uint8_t* section, std::size_t length) noexcept {
    parameters_ = rsi::Parameters{};  // all zeros: the component refuses them if the section is bad
    const ParameterSectionAnswer answer = read_parameter_section(section, length, parameters_);
    start_component(section, answer);
    protection_ = has_test_keys_ ? Protection::unsealed_test_keys : Protection::unsealed;
    return answer;
}

ParameterSectionAnswer RolloverEcu::init(const std::uint8_t* section, std::size_t length,
                                         SectionAuthority& authority) noexcept {
    parameters_ = rsi::Parameters{};
    const ParameterSectionAnswer answer = read_parameter_section(section, length, authority, parameters_);
    start_component(section, answer);
    if (answer.refusal == ParametersRefusal::none) {
        static_cast<void>(authority.raise(section));  // if the storage is busy, the next start raises it
    }
    protection_ = authority.keys().has_test_keys() ? Protection::sealed_test_keys : Protection::sealed;
    return answer;
}

void RolloverEcu::start_component(const std::uint8_t* section,
                                  const ParameterSectionAnswer& answer) noexcept {
    static_cast<void>(component_.init(parameters_));
    if (answer.refusal == ParametersRefusal::none) {
        for (std::size_t letter = 0U; letter < calibration_.name.size(); ++letter) {
            calibration_.name[letter] = section[application::section::name_at + letter];
        }
    } else {
        calibration_.name = {};
    }
    start_checks();
    refusal_ = answer.refusal;
}

void RolloverEcu::report_stored_section(ParametersRefusal refusal) noexcept {
    stored_refusal_ = refusal;
    tests_of_every_cycle_ |= monitoring::set_of(monitoring::DiagnosticCode::stored_parameters_refused);
}

void RolloverEcu::start_checks() noexcept {
    restore_learnt();
    calibration_.checksum = load_keeper_.parameters_check_word();
    component_guard_.keep(component_);
    parameter_guard_.start(parameters_);
    input_monitor_.start(parameters_);
    reception_.start(parameters_);
}

void RolloverEcu::change(const rsi::ParameterChange& change) noexcept {
    const bool other_checks = change.is_another_vehicle() || change.has_other_sensors();
    refusal_ = ParametersRefusal::none;
    parameters_ = change.parameters();
    component_.change(change);
    component_guard_.keep(component_);
    parameter_guard_.start(parameters_);
    if (other_checks) {
        input_monitor_.start(parameters_);
    }
    reception_.start(parameters_);
    load_keeper_.follow(parameters_);
    calibration_.checksum = load_keeper_.parameters_check_word();
}

// After a warm reset the load is unchanged; after power-on it may have changed.
void RolloverEcu::restore_learnt() noexcept {
    load_keeper_.restore(parameters_, component_, input_monitor_,
                         reset_reason_ == hal::ResetReason::power_on);
}

void RolloverEcu::step(std::uint32_t missed_cycles) noexcept {
    reception_.receive(bus_, missed_cycles);
    const hal::Time now = clock_.now();
    cycle_shift_ = CyclePhase::shift(reception_.imu_age(now));
    Health report = health(now, missed_cycles);
    const rsi::Inputs inputs = reception_.inputs(report.reception);
    hal::count_up(cycles_);
    memory_.begin_cycle(monitoring::Snapshot{inputs.lateral_specific_force_mps2, inputs.roll_rate_radps,
                                             inputs.roll_angle_rad, inputs.speed_mps});
    report_reception(report.reception);
    report_platform(report, now, missed_cycles);

    inputs_ = qualified(inputs, report.reception, missed_cycles);
    memory_.report(monitoring::DiagnosticCode::memory_restored, component_guard_.restore(component_));
    component_.step(inputs_, outputs_);
    const bool healthy = check_itself();
    if (!component_guard_.is_lost()) {  // else the watchdog ends it
        component_guard_.keep(component_);
    }
    if (healthy) {
        load_keeper_.keep(component_.learnt_load(), input_monitor_.lateral_offset().learnt_mps2());
    }

    report.degradation =
        monitoring::degradation_of(inputs_, outputs_, internal_fault(), memory_.confirmed_codes());
    report.diagnosis = memory_.next();
    if (is_sending_) {
        transmission_.send(bus_, outputs_, report);
    }
    if (healthy) {
        watchdog_.feed();
    }
}

// After a stall (more than most_missed_cycles) the checks start afresh, and inputs that are all unavailable
// reset the component's models.
rsi::Inputs RolloverEcu::qualified(const rsi::Inputs& inputs, const ReceptionReport& reception,
                                   std::uint32_t missed_cycles) noexcept {
    if (missed_cycles > most_missed_cycles) {
        input_monitor_.start(parameters_);
        return no_inputs;
    }
    const monitoring::FreshFrames fresh{reception.imu.is_fresh(), reception.roll_angle.is_fresh(),
                                        reception.vehicle_motion.is_fresh(),
                                        reception.vertical_acceleration_sent, reception.late_roll_angle_rad};
    return input_monitor_.qualify(inputs, fresh, outputs_, memory_);
}

// False when this cycle has found a fault in the parameters, the component's memory, the estimate or an
// output. While one of their codes is confirmed, the outputs are withdrawn.
bool RolloverEcu::check_itself() noexcept {
    using monitoring::DiagnosticCode;
    const bool parameters_good = !parameter_guard_.is_damaged(parameters_) && !component_guard_.is_failing();
    const bool computed = monitoring::has_computed(outputs_);
    const bool estimate_good = !computed || monitoring::estimate_is_in_range(outputs_);
    const bool outputs_good = !computed || monitoring::outputs_are_sound(outputs_);
    memory_.report(DiagnosticCode::parameters_damaged, !parameters_good);
    memory_.report(DiagnosticCode::estimate_out_of_range, !estimate_good);
    memory_.report(DiagnosticCode::output_not_finite, !outputs_good);
    memory_.add_tested(computed ? of_outputs : monitoring::CodeSet{0U});
    if (!estimate_good || !outputs_good) {
        component_.reset(parameters_);  // from the parameters that parameter_guard_ checks
    }
    if (internal_fault()) {
        monitoring::withdraw(outputs_);
    }
    return parameters_good && estimate_good && outputs_good;
}

bool RolloverEcu::internal_fault() const noexcept {
    using monitoring::DiagnosticCode;
    return memory_.confirmed(DiagnosticCode::parameters_damaged) ||
           memory_.confirmed(DiagnosticCode::estimate_out_of_range) ||
           memory_.confirmed(DiagnosticCode::output_not_finite);
}

void RolloverEcu::report_reception(const ReceptionReport& reception) noexcept {
    using monitoring::DiagnosticCode;
    const auto report = [this](const FrameFaults& faults, DiagnosticCode lost, DiagnosticCode damaged) {
        if (faults.received || (cycles_ > start_cycles)) {
            memory_.report(lost, faults.timeout);
        }
        memory_.report(damaged, faults.checksum_error || faults.counter_error);
    };
    report(reception.imu, DiagnosticCode::imu_lost, DiagnosticCode::imu_damaged);
    report(reception.roll_angle, DiagnosticCode::roll_angle_lost, DiagnosticCode::roll_angle_damaged);
    report(reception.vehicle_motion, DiagnosticCode::vehicle_motion_lost,
           DiagnosticCode::vehicle_motion_damaged);
    memory_.add_tested(tested_by(reception));
    const bool is_refused = (stored_refusal_ != ParametersRefusal::none);
    const bool is_failing =
        is_storage_failing_ || is_calibration_storage_failing_ || load_keeper_.is_failing();
    if (reception.has_rare_fault() || is_refused || is_failing ||
        ((memory_.active_codes() & of_rare_faults) != 0U)) {
        memory_.report(DiagnosticCode::stored_parameters_refused, is_refused);
        memory_.report(DiagnosticCode::storage_failed, is_failing);
        memory_.report(DiagnosticCode::imu_two_senders, reception.imu.two_senders);
        memory_.report(DiagnosticCode::roll_angle_two_senders, reception.roll_angle.two_senders);
        memory_.report(DiagnosticCode::vehicle_motion_two_senders, reception.vehicle_motion.two_senders);
        memory_.report(DiagnosticCode::own_identifier_received, reception.own_identifier);
        memory_.report(DiagnosticCode::imu_held_back, reception.imu_held_back);
    }
}

void RolloverEcu::report_platform(const Health& health, hal::Time now, std::uint32_t missed_cycles) noexcept {
    using monitoring::DiagnosticCode;
    memory_.report(DiagnosticCode::parameters_refused, health.parameters_invalid);
    memory_.report(DiagnosticCode::cycle_overrun, missed_cycles > 0U);
    memory_.report(DiagnosticCode::cycle_stall, missed_cycles > most_missed_cycles);
    memory_.report(DiagnosticCode::clock_jump, clock_check_.has_jumped(now.nanoseconds, missed_cycles));
    memory_.report(DiagnosticCode::bus_error, health.bus_error);
    memory_.report(DiagnosticCode::receive_overflow, health.receive_overflow);
    memory_.add_tested(tests_of_every_cycle_ | (health.bus_error ? monitoring::CodeSet{0U} : of_a_good_bus));
}

Health RolloverEcu::health(hal::Time now, std::uint32_t missed_cycles) noexcept {
    hal::count_up(cycle_overruns_, missed_cycles);
    const hal::BusStatistics statistics = bus_.statistics();
    const bool is_refused = (refusal_ != ParametersRefusal::none);
    return Health{is_refused ? refusal_ : stored_refusal_,
                  is_refused,
                  receive_overflow(statistics),
                  bus_error(statistics),
                  missed_cycles > 0U,
                  cycle_overruns_,
                  reset_reason_,
                  protection_,
                  reception_.report(now),
                  {},
                  {}};
}

// The bus is not error-active, or did not take a frame in the last cycle.
bool RolloverEcu::bus_error(const hal::BusStatistics& statistics) noexcept {
    const bool failed = has_changed(statistics.send_failures, send_failure_count_);
    return failed || (bus_.state() != hal::BusState::error_active);
}

// A received frame was dropped since the last cycle.
bool RolloverEcu::receive_overflow(const hal::BusStatistics& statistics) noexcept {
    return has_changed(statistics.frames_lost, overflow_count_);
}

}  // namespace rsi::application
