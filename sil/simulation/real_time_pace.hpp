// Real-time pace: one cycle every 10 ms of the machine's clock.
#pragma once

#include "hal/linux/periodic_tick.hpp"
#include "hal/linux/steady_clock.hpp"
#include "sil/simulation/pace.hpp"

namespace sil {

// The ECU runs on its own clock; what it sends between two cycles is read in the later one.
class RealTimePace final : public Pace {
 public:
    RealTimePace() : tick_{clock_, cycle_time} {}

    void begin_cycle(std::uint32_t number) override {
        if (number == 0U) {
            tick_.restart();
        }
        const std::uint32_t missed = tick_.wait();
        if (number == 0U) {
            origin_ = clock_.now();
        } else {
            origin_ = origin_ + hal::Time{missed * cycle_time.nanoseconds};
            missed_cycles_ += missed;
        }
    }

    void frames_sent(std::uint32_t) override {}

    bool wait_for_answer(std::uint32_t) override { return false; }

    double reception_time_s(const hal::CanFrame& frame) const override {
        return static_cast<double>((frame.receive_time - origin_).nanoseconds) * 1.0e-9;
    }

    // Cycles at which the machine was too slow: simulated time stood still for each of them.
    std::uint64_t missed_cycles() const { return missed_cycles_; }

 private:
    hal::SteadyClock clock_;
    hal::PeriodicTick<hal::SteadyClock> tick_;
    hal::Time origin_{};  // of simulated time, on the clock
    std::uint64_t missed_cycles_{0U};
};

}  // namespace sil
