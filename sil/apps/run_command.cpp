#include "sil/apps/run_command.hpp"

#include <fmt/format.h>

#include <memory>

#include "sil/apps/open_socket.hpp"
#include "sil/apps/run_recorder.hpp"
#include "sil/apps/run_timing.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/file_io.hpp"
#include "sil/page/summary_facts.hpp"
#include "sil/results/summary.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

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

}  // namespace

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

}  // namespace sil
