#include "tests/sil/acceptance/closed_run.hpp"

#include <algorithm>

#include "sil/files/calibration_file.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace rsi_test {
namespace {

class Collector final : public sil::RunObserver {
 public:
    explicit Collector(RunResult& result) : result_{result} {}

    void cycle(const sil::Truth& truth, const sil::SensorSample&, const sil::EcuFrames& ecu,
               const sil::RunEvents&) override {
        result_.states.push_back(ecu.output().state());
        result_.sides.push_back(ecu.output().side());
        result_.truths.push_back(truth);
        const rsi::can_dbc::RolloverDiagnosis& told = ecu.diagnosis();
        if (told.code_status == rsi::can_dbc::RolloverDiagnosis::CodeStatus::confirmed) {
            result_.confirmed_codes.insert(told.code);
        }
        if (static_cast<double>(ecu.output().warning().warning_level) > result_.largest_rsi) {
            result_.largest_rsi = static_cast<double>(ecu.output().warning().warning_level);
        }
    }

 private:
    RunResult& result_;
};

}  // namespace

bool RunResult::reached(sil::WarningState state) const {
    return std::find(states.begin(), states.end(), state) != states.end();
}

RunResult drive(const RunSettings& settings) {
    const std::string source{RSI_SOURCE_DIR};
    const sil::VehicleParameters vehicle =
        sil::load_vehicle(source + "/sil/vehicles/" + settings.vehicle + ".toml");
    sil::RunOptions options;
    options.mirrored = settings.mirrored;
    options.duration_s = settings.duration_s;
    sil::Manoeuvre manoeuvre = sil::find_manoeuvre(settings.manoeuvre);
    if (settings.road) {
        manoeuvre.make_road = settings.road;
    }
    const sil::VehicleParameters adapted =
        manoeuvre.adapt_vehicle ? manoeuvre.adapt_vehicle(vehicle) : vehicle;
    sil::SensorFlaws flaws;
    flaws.noise = settings.noise;
    flaws.seed = settings.seed;
    flaws.attitude_sensor = settings.attitude_sensor;
    flaws.bank_sensor = settings.bank_sensor;
    sil::SensorOptions sensors = sil::mounted_sensors(adapted, flaws);
    if (settings.sensors) {
        settings.sensors(sensors);
    }
    sil::InProcessRun run{
        vehicle, manoeuvre, options, sensors,
        sil::load_calibration(source + "/firmware/calibrations/" + settings.vehicle + ".toml",
                              settings.changes)};
    RunResult result;
    Collector collector{result};
    result.events = run.run(collector);
    return result;
}

}  // namespace rsi_test
