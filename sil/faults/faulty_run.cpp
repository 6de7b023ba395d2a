#include "sil/faults/faulty_run.hpp"

#include "sil/faults/faulty_bus.hpp"
#include "sil/faults/faulty_ecu.hpp"
#include "sil/faults/signal_fault.hpp"
#include "sil/simulation/sensor_frames.hpp"

namespace sil {
namespace {

// Most vehicles have no bank sensor; only a fault of it needs one.
SensorSample as_equipped(SensorSample sample, bool bank_sensor) {
    if (!bank_sensor) {
        sample.bank_angle_rad = SensorSample::not_available;
    }
    return sample;
}

constexpr Fault nothing{FaultKind::offset, FaultPlace::lateral_acceleration, 0.0};

}  // namespace

FaultyRun run_with_fault(const Scene& scene, const std::optional<Fault>& fault,
                         const rsi::Parameters& calibration) {
    const Fault injected = fault.value_or(nothing);
    FaultyEcu ecu{calibration, injected};
    FaultyBus bus{ecu.world_bus(), injected};
    SignalFault sensor{injected};
    SensorFrames frames;
    EcuEar ear;
    FaultyRun run;
    run.over = scene.fault_end;
    int stepped = 0;
    for (std::size_t cycle = 0U; cycle < scene.samples.size(); ++cycle) {
        const bool active = fault && cycle >= scene.fault_begin && cycle < scene.fault_end;
        ecu.begin_cycle(cycle, active);
        bus.begin_cycle(active);
        const SensorSample sample =
            as_equipped(scene.samples[cycle], injected.place == FaultPlace::bank_angle);
        frames.send(bus, sensor.apply(sample, active));
        std::optional<EcuAnswer> answer;
        if (ecu.step()) {
            answer = ear.listen(ecu.world_bus());
            ++stepped;
        }
        if (!run.visible && (bus.is_visible() || ecu.is_visible() || sensor.is_visible())) {
            run.visible = cycle;
        }
        run.answers.push_back(answer);
    }
    if (injected.kind == FaultKind::clock_jump || injected.kind == FaultKind::process_stop) {
        run.over = run.visible.value_or(scene.samples.size());  // over in that moment
    }
    run.watchdog_fed = ecu.watchdog_feeds() == stepped;
    return run;
}

}  // namespace sil
