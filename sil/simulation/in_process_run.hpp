// In-process run: a vehicle in a manoeuvre, its sensors and the firmware, put together in one process and
// driven in simulated time.
#pragma once

#include <optional>

#include "sil/simulation/closed_loop.hpp"
#include "sil/simulation/in_process_pace.hpp"
#include "sil/simulation/recorded_bus.hpp"

namespace sil {

// For campaigns, tests and benchmarks. One object is one run; several may run at once in threads of their
// own.
class InProcessRun {
 public:
    // With `log`, which must outlive the run, every frame goes into it as one of the interface vcan0. With
    // `learnt`, the firmware knows this load from the first cycle on. Throws std::invalid_argument with the
    // field's name when the calibration is refused.
    InProcessRun(const VehicleParameters& vehicle, const Manoeuvre& manoeuvre, const RunOptions& options,
                 const SensorOptions& sensors, const rsi::Parameters& calibration,
                 CandumpLogWriter* log = nullptr, const std::optional<rsi::LearntLoad>& learnt = std::nullopt)
        : plant_{vehicle, manoeuvre, options}, sensors_{sensors}, firmware_{calibration, learnt} {
        if (log != nullptr) {
            recorded_.emplace(firmware_.world_bus(), firmware_.clock(), *log, "vcan0");
        }
        loop_.emplace(plant_, sensors_, bus(), pace_);
    }
    InProcessRun(const InProcessRun&) = delete;
    InProcessRun& operator=(const InProcessRun&) = delete;

    // To be called once. Throws std::runtime_error when the bus or the log fails.
    const RunEvents& run(RunObserver& observer) {
        loop_->run(observer);
        return events();
    }
    const RunEvents& run() {
        RunObserver no_observer;
        return run(no_observer);
    }

    // For a caller that drives several runs together (RunBatch) instead of run().
    ManoeuvreRun& plant() { return plant_; }
    ClosedLoop& loop() { return *loop_; }

    const RunEvents& events() const { return loop_->events(); }
    const Truth& truth() const { return plant_.truth(); }
    const VehicleParameters& vehicle() const { return plant_.vehicle().parameters(); }
    double duration_s() const { return plant_.duration_s(); }  // if nothing ends the run before

    // Outputs of the firmware in the latest cycle, whether or not a frame carries it. The reference holds
    // for the object's life.
    const rsi::Outputs& outputs() const { return firmware_.ecu().outputs(); }

    // Its inputs; the same holds.
    const rsi::Inputs& inputs() const { return firmware_.ecu().inputs(); }

    // Content of its frames.
    const EcuFrames& frames() const { return loop_->ecu(); }
    std::uint64_t frames_sent() const { return loop_->frames_sent(); }  // to it

 private:
    rsi::hal::CanBus& bus() {
        return recorded_ ? static_cast<rsi::hal::CanBus&>(*recorded_) : firmware_.world_bus();
    }

    ManoeuvreRun plant_;
    SensorSuite sensors_;
    InProcessEcu firmware_;
    InProcessPace pace_{firmware_};
    std::optional<RecordedBus> recorded_;
    std::optional<ClosedLoop> loop_;
};

}  // namespace sil
