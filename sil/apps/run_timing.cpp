// Run timing: to an ECU behind a CAN interface in real time or in lock-step, or with the firmware in process.
#include "sil/apps/run_timing.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "hal/linux/periodic_tick.hpp"
#include "hal/linux/steady_clock.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "hal/socketcan/socket_can_bus.hpp"
#include "sil/apps/open_socket.hpp"
#include "sil/simulation/in_process_ecu.hpp"
#include "sil/simulation/in_process_pace.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/recorded_bus.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "sil/simulation/simulation.hpp"

namespace sil {
namespace {

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
void send_sync(rsi::hal::CanBus& bus, std::uint32_t number) {
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

// In real time the ECU sends by itself; without it a run would only show that no ECU responds.
class RealTime final : public RunTiming {
 public:
    explicit RealTime(const std::string& interface) {
        open_or_throw(socket_, interface);
        expect_ecu(socket_, interface);
        pace_.emplace();
    }

    rsi::hal::CanBus& bus() override { return socket_; }
    Pace& pace() override { return *pace_; }
    std::uint64_t missed_cycles() const override { return pace_->missed_cycles(); }

 private:
    rsi::hal::SocketCanBus socket_;
    std::optional<RealTimePace> pace_;  // its clock starts when the ECU is there
};

// In lock-step the ECU speaks only when asked. One that sends by itself would be taken for one that answers.
class LockStep final : public RunTiming {
 public:
    LockStep(const std::string& interface, const std::filesystem::path& log)
        : opened_{socket_, interface}, log_{log}, recorded_{socket_, simulated_time_, log_, interface} {}

    rsi::hal::CanBus& bus() override { return recorded_; }
    Pace& pace() override { return pace_; }
    void close() override { log_.close(); }

 private:
    struct Opened {
        Opened(rsi::hal::SocketCanBus& socket, const std::string& interface) {
            open_or_throw(socket, interface);
            if (hears_ecu(socket, rsi::hal::Time::from_milliseconds(50))) {
                throw std::runtime_error(fmt::format(
                    "an ECU is sending on {0} by itself. Start it for lock-step: rsi-ecu --lock-step "
                    "--interface {0} --parameters FILE",
                    interface));
            }
        }
    };

    rsi::hal::SocketCanBus socket_;
    Opened opened_;  // before there is a log
    rsi::hal::VirtualClock simulated_time_;
    CandumpLogWriter log_;
    RecordedBus recorded_;
    LockStepPace pace_{socket_, recorded_, simulated_time_};
};

// Takes everything and gives nothing.
class NoBus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame&) noexcept override {
        return rsi::hal::ReceiveResult::empty;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame&) noexcept override {
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }
};

// Writes into the log the frame with which a cycle begins in lock-step; it is not needed here.
class LoggedPace final : public Pace {
 public:
    LoggedPace(InProcessEcu& ecu, CandumpLogWriter& log, const std::string& interface)
        : pace_{ecu}, log_only_{no_bus_, ecu.clock(), log, interface} {}

    void begin_cycle(std::uint32_t number) override { pace_.begin_cycle(number); }
    void frames_sent(std::uint32_t number) override { send_sync(log_only_, number); }
    bool wait_for_answer(std::uint32_t number) override { return pace_.wait_for_answer(number); }
    double reception_time_s(const rsi::hal::CanFrame& frame) const override {
        return pace_.reception_time_s(frame);
    }

 private:
    InProcessPace pace_;
    NoBus no_bus_;
    RecordedBus log_only_;
};

class InProcess final : public RunTiming {
 public:
    InProcess(const rsi::Parameters& calibration, const std::string& interface,
              const std::filesystem::path& log)
        : firmware_{calibration},
          log_{log},
          recorded_{firmware_.world_bus(), firmware_.clock(), log_, interface},
          pace_{firmware_, log_, interface} {}

    rsi::hal::CanBus& bus() override { return recorded_; }
    Pace& pace() override { return pace_; }
    const rsi::Outputs* outputs() const override { return &firmware_.ecu().outputs(); }
    void close() override { log_.close(); }

 private:
    InProcessEcu firmware_;
    CandumpLogWriter log_;
    RecordedBus recorded_;
    LoggedPace pace_;
};

}  // namespace

std::unique_ptr<RunTiming> real_time(const std::string& interface) {
    return std::make_unique<RealTime>(interface);
}

std::unique_ptr<RunTiming> lock_step(const std::string& interface, const std::filesystem::path& log) {
    return std::make_unique<LockStep>(interface, log);
}

std::unique_ptr<RunTiming> in_process(const rsi::Parameters& calibration, const std::string& interface,
                                      const std::filesystem::path& log) {
    return std::make_unique<InProcess>(calibration, interface, log);
}

}  // namespace sil
