// Recorded bus: a CAN bus that writes every frame that passes into a candump log, stamped with simulated
// time.
#pragma once

#include <string>
#include <utility>

#include "rsi/hal/can_bus.hpp"
#include "sil/files/candump_log.hpp"

namespace sil {

// For lock-step runs, whose log must not contain the machine's clock. All three references must outlive it.
class RecordedBus final : public rsi::hal::CanBus {
 public:
    RecordedBus(rsi::hal::CanBus& bus, const rsi::hal::Clock& simulated_time, CandumpLogWriter& log,
                std::string interface)
        : bus_{bus}, simulated_time_{simulated_time}, log_{log}, interface_{std::move(interface)} {}

    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        const rsi::hal::ReceiveResult result = bus_.receive(frame);
        if (result == rsi::hal::ReceiveResult::frame) {
            record(frame);
        }
        return result;
    }

    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        const rsi::hal::SendResult result = bus_.send(frame);
        if (result == rsi::hal::SendResult::sent) {
            record(frame);
        }
        return result;
    }

    rsi::hal::BusState state() const noexcept override { return bus_.state(); }
    rsi::hal::BusStatistics statistics() const noexcept override { return bus_.statistics(); }

 private:
    void record(const rsi::hal::CanFrame& frame) {
        LoggedFrame logged{frame, interface_, 0U};
        logged.frame.receive_time = simulated_time_.now();
        log_.write(logged);
    }

    rsi::hal::CanBus& bus_;
    const rsi::hal::Clock& simulated_time_;
    CandumpLogWriter& log_;
    std::string interface_;
};

}  // namespace sil
