#include "sil/apps/run_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "sil/apps/account.hpp"
#include "sil/apps/firmware_csv.hpp"
#include "sil/apps/run_timing.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/results/event_marks.hpp"
#include "sil/results/signal_csv.hpp"
#include "sil/results/summary.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

class Recorder final : public RunObserver {
 public:
    Recorder(const std::filesystem::path& output, double duration_s)
        : csv_{output / "signals.csv"}, duration_s_{duration_s} {}

    // What only a firmware in this process tells. `outputs` must outlive the recorder.
    void look_inside(const std::filesystem::path& output, const rsi::Outputs& outputs,
                     const rsi::Parameters& calibration) {
        firmware_.emplace(output / "firmware.csv", outputs, calibration);
        lifts_.emplace(output / "lifts.csv");
    }

    Account& account() { return account_; }

    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& events) override {
        csv_.write(truth, sample, ecu.output());
        if (firmware_) {
            firmware_->write(truth);
        }
        account_.cycle(truth, ecu, events, duration_s_);
    }

    void step(const Truth& truth) override {
        if (lifts_) {
            lifts_->observe(truth);
        }
    }

    void close() {
        csv_.close();
        if (firmware_) {
            firmware_->close();
            lifts_->close();
        }
    }

    std::vector<std::pair<std::string, std::optional<double>>> index_times_s() const {
        return firmware_ ? firmware_->index_times_s()
                         : std::vector<std::pair<std::string, std::optional<double>>>{};
    }

 private:
    SignalCsvWriter csv_;
    std::optional<FirmwareCsvWriter> firmware_{};
    std::optional<LiftCsvWriter> lifts_{};
    Account account_;
    double duration_s_;
};

// Results of an earlier run must not be taken for those of this one, should it fail.
void prepare_folder(const std::filesystem::path& output) {
    std::filesystem::create_directories(output);
    for (const char* name : {"signals.csv", "events.gp", "summary.json", "firmware.csv", "lifts.csv"}) {
        std::filesystem::remove(output / name);
    }
}

std::unique_ptr<RunTiming> timing_of(const RunRequest& request, const rsi::Parameters& calibration) {
    const std::filesystem::path log = request.output / "candump.log";
    if (request.in_process) {
        return in_process(calibration, request.interface, log);
    }
    return request.lock_step ? lock_step(request.interface, log) : real_time(request.interface);
}

const char* pace_name(const RunRequest& request) {
    return request.in_process ? "in one process with the ECU"
                              : (request.lock_step ? "in lock-step with the ECU" : "in real time");
}

void write_results(const RunRequest& request, const ManoeuvreRun& plant, const ClosedLoop& loop,
                   const Recorder& recorder) {
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
    write_event_marks(loop.events(), static_stability_factor(plant.vehicle().parameters()),
                      fmt::format("{}, {}", request.manoeuvre, summary.vehicle),
                      request.output / "events.gp");
    write_summary(summary, request.output / "summary.json");
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
    prepare_folder(request.output);
    const std::unique_ptr<RunTiming> timing = timing_of(request, calibration);
    Recorder recorder{request.output, plant.duration_s()};
    if (timing->outputs() != nullptr) {
        recorder.look_inside(request.output, *timing->outputs(), calibration);
    }
    ClosedLoop loop{plant, sensors, timing->bus(), timing->pace()};

    recorder.account().begin(manoeuvre, options, pace_name(request), plant.duration_s());
    loop.run(recorder);
    recorder.account().end(loop.events(), loop.ecu(), loop.frames_sent(), timing->missed_cycles());
    recorder.close();
    timing->close();
    write_results(request, plant, loop, recorder);
}

}  // namespace sil
