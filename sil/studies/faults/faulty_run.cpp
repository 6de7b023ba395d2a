#include "sil/studies/faults/faulty_run.hpp"

#include "sil/simulation/sensor_frames.hpp"
#include "sil/studies/faults/faulty_bus.hpp"
#include "sil/studies/faults/faulty_ecu.hpp"
#include "sil/studies/faults/signal_fault.hpp"

namespace sil {

SensorSample as_equipped(SensorSample sample, const Fault& fault) {
    if (fault.place != FaultPlace::bank_angle) {
        sample.bank_angle_rad = SensorSample::not_available;
    }
    if (fault.place != FaultPlace::vehicle_mass) {
        sample.vehicle_mass_kg = SensorSample::not_available;
    }
    return sample;
}

RightRuns::RightRuns(const FaultedDrive& drive, const rsi::Parameters& calibration)
    : without_bank_{run_with_fault(drive, Fault{}, calibration)},
      with_bank_{run_with_fault(drive, Fault{FaultKind::none, FaultPlace::bank_angle, 0.0}, calibration)},
      with_mass_{run_with_fault(drive, Fault{FaultKind::none, FaultPlace::vehicle_mass, 0.0}, calibration)} {}

FaultyRun run_with_fault(const FaultedDrive& drive, const Fault& fault, const rsi::Parameters& calibration) {
    FaultyEcu ecu{calibration};
    ecu.inject(fault);
    FaultyBus bus{ecu.world_bus(), fault};
    SignalFault sensor{fault};
    SensorFrames frames;
    EcuAnswerReader reader;
    FaultyRun run;
    run.over = drive.fault_end;
    int stepped = 0;
    for (std::size_t cycle = 0U; cycle < drive.samples.size(); ++cycle) {
        const bool active = drive.has_fault(cycle);
        ecu.begin_cycle(cycle, active);
        bus.begin_cycle(active);
        frames.send(bus, sensor.apply(as_equipped(drive.samples[cycle], fault), active));
        std::optional<EcuAnswer> answer;
        if (ecu.step()) {
            answer = reader.read(ecu.world_bus());
            ++stepped;
        }
        if (!run.visible && (bus.is_visible() || ecu.is_visible() || sensor.is_visible())) {
            run.visible = cycle;
        }
        run.answers.push_back(answer);
    }
    if (fault.kind == FaultKind::clock_jump || fault.kind == FaultKind::process_stop) {
        run.over = run.visible.value_or(drive.samples.size());  // over in that moment
    }
    run.watchdog_fed = ecu.watchdog_feeds() == stepped;
    return run;
}

}  // namespace sil
