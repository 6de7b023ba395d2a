// Lock-step receiver: the ECU's side of a lock-step run. Collects frames until SimulationSync says that it is
// time.
#pragma once

#include <cstdint>
#include <optional>

#include "can_dbc/generated/rollover_warning.hpp"
#include "hal/memory/frame_ring.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "hal/socketcan/socket_can_bus.hpp"
#include "sil/simulation/pace.hpp"

namespace sil {

// A bus for the application whose frames bear simulated time. `socket` and `clock` must outlive it.
class LockStepReceiver final : public hal::CanBus {
 public:
    LockStepReceiver(hal::SocketCanBus& socket, hal::VirtualClock& clock) : socket_{socket}, clock_{clock} {}

    // Waits at most `longest` for a cycle. When it returns true, the clock stands at the cycle's time and its
    // frames wait to be received.
    bool wait_for_cycle(hal::Time longest) {
        hal::CanFrame frame;
        while (socket_.wait_for_frame(longest)) {
            while (socket_.receive(frame) == hal::ReceiveResult::frame) {
                if (frame.identifier == can_dbc::SimulationSync::identifier &&
                    frame.length == can_dbc::SimulationSync::length) {
                    begin_cycle(can_dbc::decode<can_dbc::SimulationSync>(frame.data).value.cycle_number);
                    return true;
                }
                static_cast<void>(waiting_.push(frame));
            }
        }
        return false;
    }

    // Whether the cycle is the first of a run. A receiver may serve one run after the other: each new one
    // starts at zero again, but the clock goes on.
    bool run_begins() const { return run_begins_; }

    hal::ReceiveResult receive(hal::CanFrame& frame) noexcept override {
        if (!waiting_.pop(frame)) {
            return hal::ReceiveResult::empty;
        }
        frame.receive_time = clock_.now();
        return hal::ReceiveResult::frame;
    }
    hal::SendResult send(const hal::CanFrame& frame) noexcept override { return socket_.send(frame); }
    hal::BusState state() const noexcept override { return socket_.state(); }
    hal::BusStatistics statistics() const noexcept override { return socket_.statistics(); }

 private:
    void begin_cycle(std::uint32_t number) {
        run_begins_ = !previous_number_ || number <= *previous_number_;
        if (run_begins_) {
            origin_ = clock_.now();
        }
        previous_number_ = number;
        clock_.set(origin_ + hal::Time{number * cycle_time.nanoseconds});
    }

    hal::SocketCanBus& socket_;
    hal::VirtualClock& clock_;
    hal::FrameRing<256U> waiting_;
    std::optional<std::uint32_t> previous_number_;
    hal::Time origin_{};
    bool run_begins_{false};
};

}  // namespace sil
