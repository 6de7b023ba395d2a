#include "application/rollover_ecu.hpp"

#include "hal/interface/saturating_count.hpp"

namespace application {

rsi::Validation RolloverEcu::init(const rsi::Parameters& parameters) noexcept {
    const rsi::Validation answer = component_.init(parameters);
    parameters_valid_ = (answer.accepted != 0);
    warning_indicator_ = parameters_valid_ ? static_cast<rsi_indicator>(parameters.warning_indicator)
                                           : RSI_INDICATOR_PUBLISHED;
    return answer;
}

void RolloverEcu::step(std::uint32_t missed_cycles) noexcept {
    reception_.receive(bus_);
    const hal::Time now = clock_.now();
    component_.step(reception_.inputs(now), outputs_);
    transmission_.send(bus_, warning_indicator_, outputs_, health(now, missed_cycles));
    watchdog_.feed();
}

Health RolloverEcu::health(hal::Time now, std::uint32_t missed_cycles) noexcept {
    hal::count_up(cycle_overruns_, missed_cycles);
    Health health{};
    health.parameters_valid = parameters_valid_;
    health.receive_overflow = receive_overflow();
    health.bus_state = bus_.state();
    health.cycle_overrun = (missed_cycles > 0U);
    health.cycle_overruns = cycle_overruns_;
    health.reception = reception_.report(now);
    return health;
}

// True in the cycle that follows a loss.
bool RolloverEcu::receive_overflow() noexcept {
    const std::uint32_t count = bus_.statistics().frames_lost;
    const bool grown = (count != overflow_count_);
    overflow_count_ = count;
    return grown;
}

}  // namespace application
