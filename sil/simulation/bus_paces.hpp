// Bus paces, to an ECU behind a CAN interface: real time, and lock-step.
#pragma once

#include <stdexcept>

#include "hal/linux/periodic_tick.hpp"
#include "hal/linux/steady_clock.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "hal/socketcan/socket_can_bus.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "sil/simulation/simulation.hpp"

namespace sil {

// One cycle every 10 ms of the machine's clock. The ECU runs on its own clock; what it sends between two
// cycles is read in the later one.
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
            origin_ = origin_ + rsi::hal::Time{missed * cycle_time.nanoseconds};
            missed_cycles_ += missed;
        }
    }

    void frames_sent(std::uint32_t) override {}

    bool wait_for_answer(std::uint32_t) override { return false; }

    double reception_time_s(const rsi::hal::CanFrame& frame) const override {
        return static_cast<double>((frame.receive_time - origin_).nanoseconds) * 1.0e-9;
    }

    // Cycles at which the machine was too slow: simulated time stood still for each of them.
    std::uint64_t missed_cycles() const { return missed_cycles_; }

 private:
    rsi::hal::SteadyClock clock_;
    rsi::hal::PeriodicTick<rsi::hal::SteadyClock> tick_;
    rsi::hal::Time origin_{};  // of simulated time, on the clock
    std::uint64_t missed_cycles_{0U};
};

// Lets the ECU compute cycle `number`.
inline void send_sync(rsi::hal::CanBus& bus, std::uint32_t number) {
    using simulation_dbc::SimulationSync;
    send_or_throw(bus, to_frame<SimulationSync>(rsi::can_dbc::encode(SimulationSync{number})));
}

// Simulated time stands still until the ECU has answered. Ends each cycle's sensor frames with
// SimulationSync; the ECU's status frame, the last of its answer, ends the cycle.
class LockStepPace final : public Pace {
 public:
    // `bus` is `socket` as the run sees it (recorded or not); `clock` gets simulated time. All must outlive
    // the pace.
    LockStepPace(rsi::hal::SocketCanBus& socket, rsi::hal::CanBus& bus, rsi::hal::VirtualClock& clock)
        : socket_{socket}, bus_{bus}, clock_{clock} {}

    void begin_cycle(std::uint32_t number) override {
        clock_.set(rsi::hal::Time{number * cycle_time.nanoseconds});
    }

    void frames_sent(std::uint32_t number) override { send_sync(bus_, number); }

    bool wait_for_answer(std::uint32_t) override {
        if (!socket_.wait_for_frame(longest_wait)) {
            throw std::runtime_error(
                "no answer from the ECU within 5 s. Is `rsi-ecu --lock-step` running on the same interface?");
        }
        return true;
    }

    double reception_time_s(const rsi::hal::CanFrame&) const override {
        return static_cast<double>(clock_.now().nanoseconds) * 1.0e-9;
    }

 private:
    static constexpr rsi::hal::Time longest_wait = rsi::hal::Time::from_milliseconds(5000);

    rsi::hal::SocketCanBus& socket_;
    rsi::hal::CanBus& bus_;
    rsi::hal::VirtualClock& clock_;
};

}  // namespace sil
