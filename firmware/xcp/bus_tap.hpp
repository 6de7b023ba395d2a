// Bus tap: lets an XCP slave see what the control unit receives.
#pragma once

#include "hal/interface/can_bus.hpp"
#include "xcp/slave.hpp"

namespace xcp {

// The bus as it is; nothing is taken from it. The application drops commands as it drops all that is foreign,
// and is not told of the slave's failures to send: that a bus has no room for samples is no fault of it.
class BusTap final : public hal::CanBus {
 public:
    // Both must outlive the tap.
    BusTap(hal::CanBus& bus, Slave& slave) noexcept : bus_{bus}, slave_{slave} {}

    hal::ReceiveResult receive(hal::CanFrame& frame) noexcept override {
        const hal::ReceiveResult result = bus_.receive(frame);
        if (result == hal::ReceiveResult::frame) {
            slave_.look_at(frame);
        }
        return result;
    }
    hal::SendResult send(const hal::CanFrame& frame) noexcept override { return bus_.send(frame); }
    hal::BusState state() const noexcept override { return bus_.state(); }
    hal::BusStatistics statistics() const noexcept override {
        hal::BusStatistics statistics = bus_.statistics();
        statistics.send_failures -= slave_.send_failures();  // which are among them
        return statistics;
    }

 private:
    hal::CanBus& bus_;
    Slave& slave_;
};

}  // namespace xcp
