#include "sil/apps/run_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>

#include "hal/socketcan/socket_can_bus.hpp"
#include "sil/analysis/event_marks.hpp"
#include "sil/analysis/signal_csv.hpp"
#include "sil/analysis/summary.hpp"
#include "sil/apps/account.hpp"
#include "sil/manoeuvres/catalogue.hpp"
#include "sil/simulation/lock_step_pace.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/simulation/real_time_pace.hpp"
#include "sil/simulation/recorded_bus.hpp"
#include "sil/vehicle/parameter_file.hpp"

namespace sil {
namespace {

void open_or_throw(hal::SocketCanBus& socket, const std::string& interface) {
    hal::SocketCanSettings settings;
    settings.interface_name = interface.c_str();
    const hal::OpenResult opened = socket.open(settings);
    if (!opened) {
        throw std::runtime_error(opened.message());
    }
}

// Whether an ECU sends its status frame within `longest`.
bool hears_ecu(hal::SocketCanBus& socket, hal::Time longest) {
    hal::SteadyClock clock;
    const hal::Time deadline = clock.now() + longest;
    hal::CanFrame frame;
    while (clock.now() < deadline && socket.wait_for_frame(deadline - clock.now())) {
        while (socket.receive(frame) == hal::ReceiveResult::frame) {
            if (frame.identifier == can_dbc::RolloverStatus::identifier) {
                return true;
            }
        }
    }
    return false;
}

// In real time the ECU sends by itself; without it a run would only show that nobody answers.
void expect_real_time_ecu(hal::SocketCanBus& socket, const std::string& interface) {
    if (!hears_ecu(socket, hal::Time::from_milliseconds(5000))) {
        throw std::runtime_error(
            fmt::format("no ECU is heard on {0}. Start one first: rsi-ecu --interface {0} --parameters FILE "
                        "(without --lock-step)",
                        interface));
    }
}

// In lock-step the ECU speaks only when asked. One that sends by itself would be taken for one that answers.
void expect_silent_ecu(hal::SocketCanBus& socket, const std::string& interface) {
    if (hears_ecu(socket, hal::Time::from_milliseconds(50))) {
        throw std::runtime_error(fmt::format(
            "an ECU is sending on {0} by itself. Start it for lock-step: rsi-ecu --lock-step --interface {0} "
            "--parameters FILE",
            interface));
    }
}

class Recorder final : public RunObserver {
 public:
    Recorder(const std::filesystem::path& output, double duration_s)
        : csv_{output / "signals.csv"}, duration_s_{duration_s} {}

    Account& account() { return account_; }

    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& events) override {
        csv_.write(truth, sample, ecu.output());
        account_.cycle(truth, ecu, events, duration_s_);
    }

    void close() { csv_.close(); }

 private:
    SignalCsvWriter csv_;
    Account account_;
    double duration_s_;
};

// The bus and the pace of a run, real-time or lock-step.
class Timing {
 public:
    Timing(const RunRequest& request, hal::SocketCanBus& socket) : socket_{socket} {
        if (request.lock_step) {
            expect_silent_ecu(socket, request.interface);
            log_.emplace(request.output / "candump.log");
            recorded_.emplace(socket, simulated_time_, *log_, request.interface);
            lock_step_.emplace(socket, *recorded_, simulated_time_);
        } else {
            expect_real_time_ecu(socket, request.interface);
            real_time_.emplace();
        }
    }

    hal::CanBus& bus() { return recorded_ ? static_cast<hal::CanBus&>(*recorded_) : socket_; }
    Pace& pace() { return lock_step_ ? static_cast<Pace&>(*lock_step_) : *real_time_; }

    std::uint64_t missed_cycles() const { return real_time_ ? real_time_->missed_cycles() : 0U; }

    void close() {
        if (log_) {
            log_->close();
        }
    }

 private:
    hal::SocketCanBus& socket_;
    hal::VirtualClock simulated_time_;
    std::optional<CandumpLogWriter> log_;
    std::optional<RecordedBus> recorded_;
    std::optional<LockStepPace> lock_step_;
    std::optional<RealTimePace> real_time_;
};

// Results of an earlier run must not be taken for those of this one, should it fail.
void prepare_folder(const std::filesystem::path& output) {
    std::filesystem::create_directories(output);
    for (const char* name : {"signals.csv", "events.gp", "summary.json"}) {
        std::filesystem::remove(output / name);
    }
}

void write_results(const RunRequest& request, const ManoeuvreRun& plant, const ClosedLoop& loop) {
    Summary summary;
    summary.manoeuvre = request.manoeuvre;
    summary.vehicle = plant.vehicle().parameters().name;
    summary.mirrored = request.mirrored;
    summary.lock_step = request.lock_step;
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

    hal::SocketCanBus socket;
    open_or_throw(socket, request.interface);
    prepare_folder(request.output);
    Timing timing{request, socket};
    Recorder recorder{request.output, plant.duration_s()};
    ClosedLoop loop{plant, sensors, timing.bus(), timing.pace()};

    recorder.account().begin(manoeuvre, options, request.lock_step, plant.duration_s());
    loop.run(recorder);
    recorder.account().end(loop.events(), loop.ecu(), loop.frames_sent(), timing.missed_cycles());
    recorder.close();
    timing.close();
    write_results(request, plant, loop);
}

}  // namespace sil
