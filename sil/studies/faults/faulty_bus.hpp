// Faulty bus: stands between a sender of sensor frames and the bus, and does to the frames what the fault
// says.
#pragma once

#include <cstdint>
#include <deque>

#include "rsi/hal/can_bus.hpp"
#include "sil/studies/faults/fault.hpp"

namespace sil {

// Knows nothing of who listens: in process, in lock-step and in real time alike.
class FaultyBus final : public rsi::hal::CanBus {
 public:
    // `bus` must outlive it. A fault of another kind changes nothing.
    FaultyBus(rsi::hal::CanBus& bus, const Fault& fault) : bus_{bus}, fault_{fault} {}

    // Before the frames of a cycle. `active`: whether the fault is there in this cycle.
    void begin_cycle(bool active);

    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override;
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        return bus_.receive(frame);
    }
    rsi::hal::BusState state() const noexcept override { return bus_.state(); }
    rsi::hal::BusStatistics statistics() const noexcept override { return bus_.statistics(); }

    // Whether a frame of this cycle was changed, held back, or joined by others.
    bool is_visible() const { return visible_; }

 private:
    bool is_concerned(const rsi::hal::CanFrame& frame) const;
    void send_flood();
    void send_as_ecu();
    rsi::hal::SendResult send_beside(const rsi::hal::CanFrame& frame);
    std::uint8_t next_counter();
    rsi::hal::SendResult send_delayed(const rsi::hal::CanFrame& frame);
    rsi::hal::CanFrame changed(const rsi::hal::CanFrame& frame);

    rsi::hal::CanBus& bus_;
    Fault fault_;
    bool active_{false};
    bool visible_{false};
    std::deque<rsi::hal::CanFrame> held_{};
    std::uint8_t counter_{0U};
    bool counting_{false};
};

}  // namespace sil
