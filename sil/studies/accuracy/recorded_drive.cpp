#include "sil/studies/accuracy/recorded_drive.hpp"

#include <cmath>

#include "rsi/component.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/require_accepted.hpp"
#include "sil/simulation/component_inputs.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_suite.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil::accuracy {
namespace {

constexpr double lies_on_its_side_rad = 1.2;
constexpr std::size_t steps_per_cycle = 10;

sil::SensorOptions sensors_of(const RecordedDrive& drive, const SensorQuality& quality) {
    sil::SensorOptions options = quality.noise ? sil::noisy_sensors(quality.seed) : sil::SensorOptions{};
    const auto& mount = drive.vehicle_parameters.imu_mount;
    options.imu.position = {mount.x_m, mount.y_m, mount.z_m};
    options.imu.lateral_acceleration_mps2.bias = quality.lateral_bias_g * sil::g_mps2;
    options.imu.vertical_acceleration_mps2.bias = quality.vertical_bias_g * sil::g_mps2;
    return options;
}

}  // namespace

RecordedDrive record(const std::string& manoeuvre, const std::string& vehicle, bool mirrored) {
    RecordedDrive drive;
    drive.manoeuvre = manoeuvre;
    drive.vehicle = vehicle;
    sil::RunOptions options;
    options.mirrored = mirrored;
    sil::ManoeuvreRun run{
        sil::load_vehicle(std::string{RSI_SOURCE_DIR} + "/sil/vehicles/" + vehicle + ".toml"),
        sil::find_manoeuvre(manoeuvre), options};
    drive.vehicle_parameters = run.vehicle().parameters();
    drive.truths.push_back(run.truth());
    while (!run.finished() && std::abs(run.truth().roll_angle_rad) < lies_on_its_side_rad) {
        run.step();
        drive.truths.push_back(run.truth());
    }
    return drive;
}

std::vector<Cycle> evaluate(const RecordedDrive& drive, const SensorQuality& quality,
                            const rsi::Parameters& parameters) {
    sil::SensorSuite sensors{sensors_of(drive, quality)};
    rsi::Component component;
    sil::require_accepted(component.init(parameters));
    std::vector<Cycle> cycles;
    for (std::size_t step = 0; step < drive.truths.size(); ++step) {
        const sil::Truth& truth = drive.truths[step];
        sensors.observe(truth);
        if (step % steps_per_cycle == 0) {
            Cycle cycle{&truth, {}};
            component.step(to_inputs(sensors.report(truth)), cycle.outputs);
            cycles.push_back(cycle);
        }
    }
    return cycles;
}

rsi::Parameters calibration(const std::string& vehicle) {
    return sil::load_calibration(std::string{RSI_SOURCE_DIR} + "/firmware/calibrations/" + vehicle + ".toml");
}

}  // namespace sil::accuracy
