// Closed loop: a vehicle with sensors and the ECU, joined by a CAN bus and nothing else, cycle by cycle.
#pragma once

#include <cstdint>

#include "rsi/hal/can_bus.hpp"
#include "sil/results/events.hpp"
#include "sil/simulation/ecu_frames.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_suite.hpp"

namespace sil {

// Observer of a run: called in each cycle and each step of the vehicle. The defaults do nothing.
class RunObserver {
 public:
    RunObserver() = default;
    RunObserver(const RunObserver&) = delete;
    RunObserver& operator=(const RunObserver&) = delete;
    virtual ~RunObserver() = default;

    // Before the sample is sent: returns the sample to send instead, for example with a sensor fault.
    virtual SensorSample reported(const SensorSample& sample) { return sample; }

    virtual void cycle(const Truth& /*truth*/, const SensorSample& /*sample*/, const EcuFrames& /*ecu*/,
                       const RunEvents& /*events*/) {}

    // After every step of the vehicle, ten a cycle.
    virtual void step(const Truth& /*truth*/) {}

    // After each cycle: true ends the run, because its purpose is reached.
    virtual bool settled() const { return false; }
};

class ClosedLoop {
 public:
    // All must outlive the loop.
    ClosedLoop(ManoeuvreRun& plant, SensorSuite& sensors, rsi::hal::CanBus& bus, Pace& pace);

    // Runs until the manoeuvre is over, the vehicle lies on its side, or the observer has seen enough. Throws
    // std::runtime_error when the bus or the ECU fails.
    void run(RunObserver& observer);

    // One cycle of run(), for a caller that sets the pace; false after the last one. Throws as run() does.
    bool cycle(RunObserver& observer);

    // The parts of a cycle, for a caller that steps the vehicle itself (RunBatch). Every cycle but the first
    // begins with `steps_per_cycle` steps of the vehicle, each followed by see_step(), and every cycle ends
    // with exchange(), which is false after the last one and throws as run() does.
    static constexpr int steps_per_cycle = 10;
    void see_step(RunObserver& observer);
    bool exchange(RunObserver& observer);

    const RunEvents& events() const { return events_.events(); }
    const EcuFrames& ecu() const { return ecu_; }
    std::uint64_t frames_sent() const { return sensor_frames_.frames_sent(); }

 private:
    void exchange_frames(std::uint32_t number, const SensorSample& sample);
    bool take(const rsi::hal::CanFrame& frame);

    ManoeuvreRun& plant_;
    SensorSuite& sensors_;
    rsi::hal::CanBus& bus_;
    Pace& pace_;
    SensorFrames sensor_frames_{};
    EcuFrames ecu_{};
    std::uint32_t number_{0U};  // of the next cycle
    EventObserver events_;
};

}  // namespace sil
