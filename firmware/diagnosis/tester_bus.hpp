// Tester bus: the bus as the application sees it while a tester is on it. The application is the same with
// and without diagnosis.
#pragma once

#include "diagnosis/iso_tp.hpp"
#include "hal/interface/can_bus.hpp"

namespace diagnosis {

// Hands each frame to ISO-TP as well. CommunicationControl keeps the application's own frames from the bus.
class TesterBus final : public hal::CanBus {
 public:
    // Both must outlive this object.
    TesterBus(hal::CanBus& bus, IsoTp& transport) noexcept : bus_{bus}, transport_{transport} {}

    hal::ReceiveResult receive(hal::CanFrame& frame) noexcept override {
        const hal::ReceiveResult result = bus_.receive(frame);
        if (result == hal::ReceiveResult::frame) {
            transport_.take(frame);
        }
        return result;
    }

    hal::SendResult send(const hal::CanFrame& frame) noexcept override {
        return is_sending_ ? bus_.send(frame) : hal::SendResult::sent;
    }

    hal::BusState state() const noexcept override { return bus_.state(); }
    hal::BusStatistics statistics() const noexcept override { return bus_.statistics(); }

    void set_sending(bool is_sending) noexcept { is_sending_ = is_sending; }

 private:
    hal::CanBus& bus_;
    IsoTp& transport_;
    bool is_sending_{true};
};

}  // namespace diagnosis
