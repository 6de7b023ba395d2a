// Recorded bus: a CAN bus that writes every frame that passes into a candump log, stamped with simulated
// time.
#pragma once

#include <string>
#include <utility>

#include "hal/interface/can_bus.hpp"
#include "sil/files/candump_log.hpp"

namespace sil {

// For lock-step runs, whose log must not contain the machine's clock. All three references must outlive it.
class RecordedBus final : public hal::CanBus {
 public:
    RecordedBus(hal::CanBus& bus, const hal::Clock& simulated_time, CandumpLogWriter& log,
                std::string interface)
        : bus_{bus}, simulated_time_{simulated_time}, log_{log}, interface_{std::move(interface)} {}

    hal::ReceiveResult receive(hal::CanFrame& frame) noexcept override {
        const hal::ReceiveResult result = bus_.receive(frame);
        if (result == hal::ReceiveResult::frame) {
            record(frame);
        }
        return result;
    }

    hal::SendResult send(const hal::CanFrame& frame) noexcept override {
        const hal::SendResult result = bus_.send(frame);
        if (result == hal::SendResult::sent) {
            record(frame);
        }
        return result;
    }

    hal::BusState state() const noexcept override { return bus_.state(); }
    hal::BusStatistics statistics() const noexcept override { return bus_.statistics(); }

 private:
    void record(const hal::CanFrame& frame) {
        LoggedFrame logged{frame, interface_, 0U};
        logged.frame.receive_time = simulated_time_.now();
        log_.write(logged);
    }

    hal::CanBus& bus_;
    const hal::Clock& simulated_time_;
    CandumpLogWriter& log_;
    std::string interface_;
};

}  // namespace sil
