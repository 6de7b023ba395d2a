#include "sil/studies/campaign/learning_drive.hpp"

#include <algorithm>

#include "rsi/component.hpp"
#include "sil/files/require_accepted.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/mixed_driving.hpp"

namespace sil {
namespace {

constexpr double speed_kmh = 80.0;
constexpr double largest_acceleration_g = 0.4;     // of ordinary driving
constexpr double share_of_stability_factor = 0.5;  // trucks are driven with more care

class InputRecorder final : public RunObserver {
 public:
    explicit InputRecorder(const InProcessRun& run) : run_{run} {}
    void cycle(const Truth&, const SensorSample&, const EcuFrames&, const RunEvents&) override {
        inputs.push_back(run_.inputs());
    }

    std::vector<rsi::Inputs> inputs{};

 private:
    const InProcessRun& run_;
};

}  // namespace

std::vector<rsi::Inputs> learning_drive(const VehicleParameters& vehicle, const SensorOptions& sensors,
                                        const rsi::Parameters& calibration, double duration_s) {
    const double share =
        std::min(1.0, share_of_stability_factor * static_stability_factor(vehicle) / largest_acceleration_g);
    const Manoeuvre manoeuvre = ordinary_driving(sensors.seed, duration_s, share);
    RunOptions options;
    options.speed_factor = from_kmh(speed_kmh) / manoeuvre.initial_speed_mps;
    InProcessRun run{vehicle, manoeuvre, options, sensors, calibration};
    InputRecorder recorder{run};
    run.run(recorder);
    return std::move(recorder.inputs);
}

rsi::LearntLoad learnt_load(const std::vector<rsi::Inputs>& drive, const rsi::Parameters& calibration,
                            double mass_sensor_error) {
    rsi::Component component;
    require_accepted(component.init(calibration));
    rsi::Outputs outputs{};
    for (rsi::Inputs inputs : drive) {
        inputs.vehicle_mass_kg *= static_cast<float>(1.0 + mass_sensor_error);  // not available stays so
        component.step(inputs, outputs);
    }
    return component.learnt_load();
}

}  // namespace sil
