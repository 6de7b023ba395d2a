// Lock-step receiver: the ECU's side of a lock-step run. Collects frames until SimulationSync says that it is
// time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/memory/frame_ring.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/simulation.hpp"

namespace sil {

// A bus for the application whose frames bear simulated time; holds back up to `capacity` frames of a cycle.
// Needs no operating system, so that a controller's image may have it too. `bus` and `clock` must outlive it.
template <std::size_t capacity>
class LockStepReceiver final : public rsi::hal::CanBus {
 public:
    LockStepReceiver(rsi::hal::CanBus& bus, rsi::hal::VirtualClock& clock) noexcept
        : bus_{bus}, clock_{clock} {}

    // Reads what waits on the bus. When it returns true, a cycle is complete: the clock stands at its time
    // and its frames wait to be received. Call it again at once after the cycle, for the bus may hold more.
    bool cycle_is_complete() noexcept {
        rsi::hal::CanFrame frame;
        while (bus_.receive(frame) == rsi::hal::ReceiveResult::frame) {
            if (frame.identifier == simulation_dbc::SimulationSync::identifier &&
                frame.length == simulation_dbc::SimulationSync::length) {
                begin_cycle(
                    rsi::can_dbc::decode<simulation_dbc::SimulationSync>(frame.data).value.cycle_number);
                return true;
            }
            static_cast<void>(waiting_.push(frame));
        }
        return false;
    }

    // Whether the cycle is the first of a run. A receiver may serve one run after the other: each new one
    // starts at zero again, but the clock goes on.
    bool run_begins() const noexcept { return run_begins_; }

    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        if (!waiting_.pop(frame)) {
            return rsi::hal::ReceiveResult::empty;
        }
        frame.receive_time = clock_.now();
        return rsi::hal::ReceiveResult::frame;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override { return bus_.send(frame); }
    rsi::hal::BusState state() const noexcept override { return bus_.state(); }
    rsi::hal::BusStatistics statistics() const noexcept override { return bus_.statistics(); }

 private:
    void begin_cycle(std::uint32_t number) noexcept {
        run_begins_ = first_ || number <= previous_number_;
        if (run_begins_) {
            origin_ = clock_.now();
        }
        first_ = false;
        previous_number_ = number;
        static_cast<void>(clock_.set(origin_ + rsi::hal::Time{number * cycle_time.nanoseconds}));
    }

    rsi::hal::CanBus& bus_;
    rsi::hal::VirtualClock& clock_;
    rsi::hal::FrameRing<capacity> waiting_;
    std::uint32_t previous_number_{0U};
    rsi::hal::Time origin_{};
    bool first_{true};
    bool run_begins_{false};
};

}  // namespace sil
