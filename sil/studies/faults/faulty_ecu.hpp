// Faulty ECU: the firmware in this process, with a clock that may jump, a controller that may go off the bus
// and a processor that may stop.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/memory/memory_bus.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "sil/files/require_accepted.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/studies/faults/fault.hpp"

namespace sil {

class FaultyEcu {
 public:
    // Throws std::invalid_argument with the field's name when the parameters are refused.
    explicit FaultyEcu(const rsi::Parameters& parameters) : ecu_{bus_.endpoint(0U), clock_, watchdog_} {
        require_accepted(ecu_.init(parameters));
    }

    // The fault of the cycles that begin_cycle() calls active; to be called while none is.
    void inject(const Fault& fault) { fault_ = fault; }

    rsi::hal::CanBus& world_bus() { return bus_.endpoint(1U); }

    // Before the sensor frames of a cycle. `active`: whether the fault is there in this cycle.
    void begin_cycle(std::size_t number, bool active);

    // After them; false when the processor stands.
    bool step();

    // Whether the ECU's own fault was there in this cycle.
    bool is_visible() const { return visible_; }
    int watchdog_feeds() const { return watchdog_.feeds; }
    const rsi::Outputs& outputs() const { return ecu_.outputs(); }

 private:
    // Unlike a VirtualClock it can also jump back, which no clock should.
    struct JumpingClock final : rsi::hal::Clock {
        rsi::hal::Time now() const noexcept override { return time; }
        rsi::hal::Time time{};
    };
    struct CountingWatchdog final : rsi::hal::Watchdog {
        void feed() noexcept override { ++feeds; }
        int feeds{0};
    };

    Fault fault_{};
    JumpingClock clock_{};
    rsi::hal::MemoryBus<2U> bus_{clock_};
    CountingWatchdog watchdog_{};
    rsi::application::RolloverEcu ecu_;
    rsi::hal::Time jumped_{};
    std::size_t stopped_cycles_{0U};
    std::uint32_t missed_cycles_{0U};
    bool jumps_{false};
    bool active_{false};
    bool visible_{false};
};

inline void FaultyEcu::begin_cycle(std::size_t number, bool active) {
    const bool begins = active && !active_;
    const bool ends = !active && active_;
    active_ = active;
    visible_ = false;
    const auto milliseconds = static_cast<std::int64_t>(fault_.magnitude);
    switch (fault_.kind) {
        case FaultKind::bus_off:
        case FaultKind::error_passive:
            if (begins || ends) {
                const rsi::hal::BusState faulty = fault_.kind == FaultKind::bus_off
                                                      ? rsi::hal::BusState::bus_off
                                                      : rsi::hal::BusState::error_passive;
                bus_.endpoint(0U).set_state(active ? faulty : rsi::hal::BusState::error_active);
            }
            // Off the bus, the ECU can say nothing until it is back.
            visible_ = fault_.kind == FaultKind::bus_off ? ends : active;
            break;
        case FaultKind::clock_jump:
            jumps_ = begins;
            break;
        case FaultKind::process_stop:
            if (begins) {
                stopped_cycles_ = static_cast<std::size_t>(milliseconds / 10);
            }
            break;
        default:
            break;
    }
    clock_.time = rsi::hal::Time{static_cast<std::int64_t>(number) * cycle_time.nanoseconds} + jumped_;
}

inline bool FaultyEcu::step() {
    if (stopped_cycles_ > 0U) {
        --stopped_cycles_;
        ++missed_cycles_;
        return false;
    }
    if (jumps_) {  // the frames that wait were stamped before
        const rsi::hal::Time jump =
            rsi::hal::Time::from_milliseconds(static_cast<std::int64_t>(fault_.magnitude));
        jumped_ = jumped_ + jump;
        clock_.time = clock_.time + jump;
        visible_ = true;
    }
    visible_ = visible_ || missed_cycles_ > 0U;
    ecu_.step(missed_cycles_);
    missed_cycles_ = 0U;
    return true;
}

}  // namespace sil
