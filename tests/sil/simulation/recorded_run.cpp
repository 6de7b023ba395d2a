#include "tests/sil/simulation/recorded_run.hpp"

#include "sil/files/calibration_file.hpp"
#include "sil/files/sensor_frame.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace testing_simulation {
namespace {

const std::string project_folder = RSI_PROJECT_FOLDER;

class OutputRecorder final : public sil::RunObserver {
 public:
    explicit OutputRecorder(std::vector<sil::EcuOutput>& outputs) : outputs_{outputs} {}
    void cycle(const sil::Truth&, const sil::SensorSample&, const sil::EcuFrames& ecu,
               const sil::RunEvents&) override {
        outputs_.push_back(ecu.output());
    }

 private:
    std::vector<sil::EcuOutput>& outputs_;
};

}  // namespace

sil::Manoeuvre hard_turn() {
    sil::Manoeuvre manoeuvre = sil::find_manoeuvre("j-turn-45");
    manoeuvre.name = "hard-turn";
    manoeuvre.initial_speed_mps = sil::from_kmh(80.0);
    manoeuvre.make_driver = sil::open_loop([](double time_s) {
        return sil::DriverCommand{
            sil::ramp_and_hold(time_s, 0.5, sil::from_degrees(400.0), sil::from_degrees(300.0)),
            sil::SpeedPolicy::held};
    });
    return manoeuvre;
}

rsi::Parameters large_suv_calibration() {
    return sil::load_calibration(project_folder + "/firmware/calibrations/large_suv.toml");
}

RecordedRun run_and_record(const sil::Manoeuvre& manoeuvre, const RunSettings& settings) {
    const test_support::ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "candump.log";
    sil::RunOptions options;
    options.mirrored = settings.mirrored;
    options.duration_s = settings.duration_s;
    const sil::VehicleParameters vehicle = sil::load_vehicle(project_folder + "/sil/vehicles/large_suv.toml");
    sil::CandumpLogWriter log{path};
    sil::InProcessRun whole{vehicle,
                            manoeuvre,
                            options,
                            sil::mounted_sensors(vehicle, {settings.noise, settings.seed}),
                            large_suv_calibration(),
                            &log};

    RecordedRun run;
    OutputRecorder recorder{run.ecu_outputs};
    run.events = whole.run(recorder);
    log.close();
    run.log_text = test_support::text_of(path);
    run.log = sil::read_candump_log(path);
    run.frames_refused = whole.frames().frames_refused();
    return run;
}

std::vector<std::string> ecu_payloads(const std::vector<sil::LoggedFrame>& log) {
    std::vector<std::string> lines;
    for (sil::LoggedFrame logged : log) {
        if (!sil::is_sensor_frame(logged.frame)) {
            logged.frame.receive_time = {};
            lines.push_back(sil::format_candump_line(logged));
        }
    }
    return lines;
}

}  // namespace testing_simulation
