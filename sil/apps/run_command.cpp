// Run command: one manoeuvre on a CAN interface or in this process, from request to results.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sil/apps/command_line.hpp"
#include "sil/apps/commands.hpp"
#include "sil/apps/open_socket.hpp"
#include "sil/apps/run_recorder.hpp"
#include "sil/apps/run_timing.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/file_io.hpp"
#include "sil/page/summary_facts.hpp"
#include "sil/results/summary.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

struct RunRequest {
    std::string manoeuvre;
    std::string interface{"vcan0"};
    std::string vehicle_file;
    std::filesystem::path output;
    SensorFlaws sensors{};
    double duration_s{0.0};  // 0: the manoeuvre's own
    bool mirrored{false};
    bool lock_step{false};
    bool in_process{false};
    std::string calibration_file{};      // in process only
    std::vector<std::string> changes{};  // of the calibration, as "key=value"
};

// In real time another process may write a log of this name.
std::filesystem::path log_of(const RunRequest& request) {
    return request.output / "candump.log";
}

std::unique_ptr<RunTiming> timing_of(const RunRequest& request, const rsi::Parameters& calibration) {
    if (request.in_process) {
        return in_process(calibration, request.interface, log_of(request));
    }
    return request.lock_step ? lock_step(request.interface, log_of(request)) : real_time(request.interface);
}

Summary summary_of(const RunRequest& request, const ManoeuvreRun& plant, const ClosedLoop& loop,
                   const RunRecorder& recorder) {
    Summary summary;
    summary.manoeuvre = request.manoeuvre;
    summary.vehicle = plant.vehicle().parameters().name;
    summary.mirrored = request.mirrored;
    summary.lock_step = request.lock_step;
    summary.in_process = request.in_process;
    summary.index_times_s = recorder.index_times_s();
    summary.seed = request.sensors.seed;
    summary.noise = request.sensors.noise ? "noise" : "none";
    summary.bias_g = request.sensors.bias_g;
    summary.quantisation_g = request.sensors.quantisation_g;
    summary.versions = built_versions();
    summary.events = loop.events();
    summary.frames_sent = loop.frames_sent();
    summary.frames_received = loop.ecu().frames_received();
    return summary;
}

// Drives the manoeuvre, prints the account and writes signals.csv, events.gp, report.html and summary.json
// into the output folder, in lock-step candump.log too, and in process also firmware.csv and lifts.csv.
void run_manoeuvre(const RunRequest& request) {
    const Manoeuvre manoeuvre = find_manoeuvre(request.manoeuvre);
    const VehicleParameters parameters = load_vehicle(request.vehicle_file);
    RunOptions options;
    options.mirrored = request.mirrored;
    options.duration_s = request.duration_s;
    ManoeuvreRun plant{parameters, manoeuvre, options};
    SensorSuite sensors{mounted_sensors(parameters, request.sensors)};

    rsi::Parameters calibration{};
    if (request.in_process) {
        calibration = load_calibration(request.calibration_file, request.changes);
    } else {
        check_interface(request.interface);
    }
    prepare_run_folder(request.output);
    if (request.in_process || request.lock_step) {
        remove_file(log_of(request));
    }
    const std::unique_ptr<RunTiming> timing = timing_of(request, calibration);
    RunRecorder recorder{request.output, plant.duration_s()};
    if (timing->outputs() != nullptr) {
        recorder.look_inside(*timing->outputs(), calibration);
    }
    ClosedLoop loop{plant, sensors, timing->bus(), timing->pace()};

    recorder.console().begin(manoeuvre, options, pace_name(request.in_process, request.lock_step),
                             plant.duration_s());
    loop.run(recorder);
    recorder.console().end(loop.events(), loop.ecu(), loop.frames_sent(), timing->missed_cycles());
    recorder.close();
    timing->close();
    write_run_results(summary_of(request, plant, loop, recorder), plant.vehicle().parameters(),
                      recorder.page(), request.output);
}

void add_pace(CLI::App& run, RunRequest& request) {
    CLI::Option* interface = run.add_option("--interface", request.interface, "CAN interface");
    interface->capture_default_str();
    CLI::Option* lock_step = run.add_flag("--lock-step", request.lock_step,
                                          "Simulated time: every cycle waits for the ECU's answer");
    CLI::Option* in_process = run.add_flag(
        "--in-process", request.in_process,
        "The firmware in this process, without a CAN interface: the results of a lock-step run and more");
    in_process->excludes(interface)->excludes(lock_step);
    CLI::Option* parameters = run.add_option("--parameters", request.calibration_file,
                                             "Calibration of the firmware in process (TOML)");
    parameters->needs(in_process);
    in_process->needs(parameters);
    run.add_option("--set", request.changes,
                   "KEY=VALUE in place of what the calibration says; may be repeated")
        ->allow_extra_args(false)
        ->needs(parameters);
}

}  // namespace

void add_run_command(CLI::App& app) {
    const auto request = std::make_shared<RunRequest>();
    CLI::App* run =
        app.add_subcommand("run", "Drive a manoeuvre against an ECU, on a CAN interface or in this process");
    run->add_option("manoeuvre", request->manoeuvre, "Its name; `rsi-sil list` names all")->required();
    run->add_option("--vehicle", request->vehicle_file, "Parameter file of the simulated vehicle (TOML)")
        ->required();
    run->add_option("--output", request->output, "Folder for the results")->required();
    add_whole_number(*run, "--seed", request->sensors.seed, "Seed of the sensor noise")
        ->default_str(fmt::format("{}", request->sensors.seed));
    run->add_option("--duration", request->duration_s, "Seconds of simulated time (default: the manoeuvre's)")
        ->check(number_within(0.01, 1.0e6));
    run->add_option("--bias", request->sensors.bias_g, "Bias of the accelerometers, in g (-1 to 1)")
        ->check(number_within(-1.0, 1.0));
    run->add_option("--quantisation", request->sensors.quantisation_g,
                    "Least step of the accelerometers, in g (0 to 1)")
        ->check(number_within(0.0, 1.0));
    run->add_flag("--bank-sensor", request->sensors.bank_sensor, "The vehicle measures the road's bank, too");
    run->add_flag("--attitude-sensor", request->sensors.attitude_sensor,
                  "The vehicle measures the roll angle against the horizon, not against the road");
    run->add_flag("--mass-sensor", request->sensors.mass_sensor,
                  "The vehicle measures its mass by the axle loads, as trucks do");
    run->add_flag("--noise", request->sensors.noise, "Sensors with noise");
    run->add_flag("--mirror", request->mirrored, "Left and right exchanged");
    add_pace(*run, *request);
    run->callback([request] { run_manoeuvre(*request); });
}

}  // namespace sil
