// Memory bus: a CAN bus inside one process, for tests and for runs without a network interface.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

#include "hal/memory/frame_ring.hpp"
#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/saturating_count.hpp"
#include "rsi/hal/well_formed.hpp"

namespace rsi::hal {

// Connects `endpoint_count` endpoints, each of which is a CanBus. Every other endpoint receives what one
// sends, in the order of sending and stamped with `clock.now()`; none receives its own frames. An endpoint
// holds up to `capacity` frames; when it is full, further frames are lost to it and counted, and the sender
// does not notice. No heap: all frames live inside the object (about 90 bytes a frame).
template <std::size_t endpoint_count, std::size_t capacity = 256U>
class MemoryBus {
 public:
    class Endpoint final : public CanBus {
     public:
        Endpoint() noexcept = default;

        ReceiveResult receive(CanFrame& frame) noexcept override {
            if (state_ == BusState::closed) {
                return ReceiveResult::failed;
            }
            if (!waiting_.pop(frame)) {
                return ReceiveResult::empty;
            }
            count_up(statistics_.frames_received);
            return ReceiveResult::frame;
        }

        SendResult send(const CanFrame& frame) noexcept override {
            if (!can_take_part() || !is_well_formed(frame)) {
                count_up(statistics_.send_failures);
                return SendResult::failed;
            }
            bus_->distribute(frame, *this);
            count_up(statistics_.frames_sent);
            return SendResult::sent;
        }

        BusState state() const noexcept override { return state_; }
        BusStatistics statistics() const noexcept override { return statistics_; }

        // Makes the endpoint behave as a controller in this state: in `bus_off` it neither sends nor hears,
        // in `closed` it gives out nothing either. Frames that already wait stay until they are read.
        void set_state(BusState state) noexcept { state_ = state; }

     private:
        friend class MemoryBus;

        bool can_take_part() const noexcept {
            return state_ == BusState::error_active || state_ == BusState::error_passive;
        }

        void hear(const CanFrame& frame) noexcept {
            if (can_take_part() && !waiting_.push(frame)) {
                count_up(statistics_.frames_lost);
            }
        }

        MemoryBus* bus_{nullptr};
        FrameRing<capacity> waiting_;
        BusStatistics statistics_;
        BusState state_{BusState::error_active};
    };

    // `clock` must outlive the bus.
    explicit MemoryBus(const Clock& clock) noexcept : clock_(clock) {
        for (Endpoint& endpoint : endpoints_) {
            endpoint.bus_ = this;
        }
    }
    MemoryBus(const MemoryBus&) = delete;
    MemoryBus& operator=(const MemoryBus&) = delete;

    // `index` from 0 to endpoint_count - 1.
    Endpoint& endpoint(std::size_t index) noexcept {
        assert(index < endpoint_count);
        return endpoints_[index];
    }

 private:
    void distribute(const CanFrame& frame, const Endpoint& sender) noexcept {
        CanFrame stamped = frame;
        stamped.receive_time = clock_.now();
        for (Endpoint& endpoint : endpoints_) {
            if (&endpoint != &sender) {
                endpoint.hear(stamped);
            }
        }
    }

    const Clock& clock_;
    std::array<Endpoint, endpoint_count> endpoints_;
};

}  // namespace rsi::hal
