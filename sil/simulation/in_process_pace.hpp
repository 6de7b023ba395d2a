// In-process pace: simulated time, with the ECU stepped by a call.
#pragma once

#include "sil/simulation/in_process_ecu.hpp"
#include "sil/simulation/pace.hpp"

namespace sil {

class InProcessPace final : public Pace {
 public:
    // `ecu` must outlive the pace.
    explicit InProcessPace(InProcessEcu& ecu) : ecu_{ecu} {}

    void begin_cycle(std::uint32_t number) override {
        ecu_.clock().set(rsi::hal::Time{number * cycle_time.nanoseconds});
        stepped_ = false;
    }

    void frames_sent(std::uint32_t) override {}

    bool wait_for_answer(std::uint32_t) override {
        if (stepped_) {
            return false;
        }
        ecu_.step();
        stepped_ = true;
        return true;
    }

    double reception_time_s(const rsi::hal::CanFrame& frame) const override {
        return static_cast<double>(frame.receive_time.nanoseconds) * 1.0e-9;
    }

 private:
    InProcessEcu& ecu_;
    bool stepped_{false};
};

}  // namespace sil
