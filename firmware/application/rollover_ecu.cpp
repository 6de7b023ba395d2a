#include "application/rollover_ecu.hpp"

#include "hal/interface/saturating_count.hpp"

namespace application {
namespace {

constexpr std::uint32_t most_missed_cycles = 2U;

// True when `count` is not what it was at the last call.
bool has_changed(std::uint32_t count, std::uint32_t& previous) {
    const bool changed = (count != previous);
    previous = count;
    return changed;
}

}  // namespace

rsi::Validation RolloverEcu::init(const rsi::Parameters& parameters) noexcept {
    const rsi::Validation answer = component_.init(parameters);
    refusal_ = (answer.accepted != 0) ? ParametersRefusal::none : ParametersRefusal::value;
    return answer;
}

ParameterSectionAnswer RolloverEcu::init(const std::uint8_t* section, std::size_t length) noexcept {
    rsi::Parameters parameters{};  // which the component refuses, unless the section replaces them
    const ParameterSectionAnswer answer = read_parameter_section(section, length, parameters);
    static_cast<void>(component_.init(parameters));
    refusal_ = answer.refusal;
    return answer;
}

void RolloverEcu::step(std::uint32_t missed_cycles) noexcept {
    reception_.receive(bus_);
    const hal::Time now = clock_.now();
    const bool stalled = (missed_cycles > most_missed_cycles);
    inputs_ = stalled ? no_inputs : reception_.inputs(now);
    component_.step(inputs_, outputs_);
    transmission_.send(bus_, outputs_, health(now, missed_cycles));
    watchdog_.feed();
}

Health RolloverEcu::health(hal::Time now, std::uint32_t missed_cycles) noexcept {
    hal::count_up(cycle_overruns_, missed_cycles);
    Health health{};
    health.parameters_refusal = refusal_;
    health.reset_reason = reset_reason_;
    health.receive_overflow = receive_overflow();
    health.bus_error = bus_error();
    health.cycle_overrun = (missed_cycles > 0U);
    health.cycle_overruns = cycle_overruns_;
    health.reception = reception_.report(now);
    return health;
}

// The bus is not error-active, or did not take a frame in the last cycle.
bool RolloverEcu::bus_error() noexcept {
    const bool failed = has_changed(bus_.statistics().send_failures, send_failure_count_);
    return failed || (bus_.state() != hal::BusState::error_active);
}

// True in the cycle that follows a loss.
bool RolloverEcu::receive_overflow() noexcept {
    return has_changed(bus_.statistics().frames_lost, overflow_count_);
}

}  // namespace application
