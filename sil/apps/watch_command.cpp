#include "sil/apps/commands.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "hal/linux/steady_clock.hpp"
#include "sil/apps/command_line.hpp"
#include "sil/apps/open_socket.hpp"
#include "sil/apps/run_recorder.hpp"
#include "sil/apps/stop_request.hpp"
#include "sil/apps/vehicle_options.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/file_io.hpp"
#include "sil/live/live_ecu.hpp"
#include "sil/live/live_server.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

// The ECU runs on its own clock; what it sends between two cycles is read in the later one, and was received
// when the socket says.
class BusPace final : public Pace {
 public:
    void begin_cycle(std::uint32_t number) override {
        ahead_ = rsi::hal::Time{number * cycle_time.nanoseconds} - clock_.now();
    }
    void frames_sent(std::uint32_t) override {}
    bool wait_for_answer(std::uint32_t) override { return false; }
    double reception_time_s(const rsi::hal::CanFrame& frame) const override {
        return static_cast<double>((frame.receive_time + ahead_).nanoseconds) * 1.0e-9;
    }

 private:
    rsi::hal::SteadyClock clock_;
    rsi::hal::Time ahead_{};  // of simulated time, to the clock
};

class OnBus final : public LiveEcu {
 public:
    explicit OnBus(const std::string& interface) { open_or_throw(socket_, interface); }

    rsi::hal::CanBus& bus() override { return socket_; }
    Pace& pace() override { return pace_; }
    const rsi::Outputs* outputs() const override { return nullptr; }

 private:
    rsi::hal::SocketCanBus socket_;
    BusPace pace_;
};

// Throws std::runtime_error with a message for the user when there is no such interface.
std::unique_ptr<LiveEcu> live_ecu_on_bus(const std::string& interface) {
    return std::make_unique<OnBus>(interface);
}

struct WatchRequest {
    std::string manoeuvre{};
    VehicleFiles files{};
    std::filesystem::path output{};
    SensorFlaws
        sensors{};  // with noise, without which a vehicle straight ahead makes every sensor look stuck
    double speed_kmh{80.0};
    std::uint64_t port{0U};
    std::string interface{};  // empty: the firmware in this process
};

// signals.csv and all that belongs to it, of the latest drive.
class WatchRecorder final : public LiveRecorder {
 public:
    WatchRecorder(const LiveDrive& drive, const WatchRequest& request, const rsi::Parameters& calibration)
        : drive_{drive}, request_{request} {
        prepare_run_folder(request.output);
        remove_file(request.output / "candump.log");  // of an earlier run: this one has no log
        recorder_.emplace(request.output, drive.plant().duration_s());
        if (drive.outputs() != nullptr) {
            recorder_->look_inside(*drive.outputs(), calibration);
        }
    }

    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& events) override {
        recorder_->cycle(truth, sample, ecu, events);
    }
    void step(const Truth& truth) override { recorder_->step(truth); }

    void finish() override {
        recorder_->close();
        Summary summary;
        summary.manoeuvre = drive_.manoeuvre().name;
        summary.vehicle = drive_.plant().vehicle().parameters().name;
        summary.in_process = drive_.outputs() != nullptr;
        summary.index_times_s = recorder_->index_times_s();
        summary.seed = request_.sensors.seed;
        summary.noise = request_.sensors.noise ? "noise" : "none";
        summary.versions = built_versions();
        summary.events = drive_.loop().events();
        summary.frames_sent = drive_.loop().frames_sent();
        summary.frames_received = drive_.loop().ecu().frames_received();
        write_run_results(summary, drive_.plant().vehicle().parameters(), recorder_->page(), request_.output);
    }

 private:
    const LiveDrive& drive_;
    const WatchRequest& request_;
    std::optional<RunRecorder> recorder_{};
};

void watch(const WatchRequest& request) {
    const std::atomic<bool>& stop = stop_on_signals();
    LiveVehicle what;
    what.vehicle = load_vehicle(request.files.vehicle);
    const rsi::Parameters calibration = load_calibration(request.files.calibration);
    if (request.interface.empty()) {
        what.make_ecu = [&calibration] { return live_ecu_in_process(calibration); };
        what.ecu_text = "the firmware in the same process";
    } else {
        rsi::hal::SocketCanBus socket;
        open_or_throw(socket, request.interface);
        expect_ecu(socket, request.interface);
        what.make_ecu = [&request] { return live_ecu_on_bus(request.interface); };
        what.ecu_text = "the ECU on " + request.interface;
    }
    what.sensors = request.sensors;
    if (!request.manoeuvre.empty()) {
        what.manoeuvre = find_manoeuvre(request.manoeuvre);
    }
    LiveSession session{what, request.speed_kmh, [&](const LiveDrive& drive) {
                            return std::make_unique<WatchRecorder>(drive, request, calibration);
                        }};
    serve_live(session, static_cast<std::uint16_t>(request.port), stop, [](std::uint16_t port) {
        fmt::print("Open http://127.0.0.1:{}/ in a browser of this machine. Ctrl-C ends the drive.\n", port);
        std::fflush(stdout);
    });
    session.finish();
}

}  // namespace

void add_watch_command(CLI::App& app) {
    const auto request = std::make_shared<WatchRequest>();
    request->sensors.noise = true;
    CLI::App* command = app.add_subcommand(
        "watch",
        "Drive the vehicle in a browser, against the firmware in this process or an ECU on a "
        "CAN interface, in real time; break its sensors and load its roof; or watch a "
        "manoeuvre. Serves one page, to this machine only");
    command->add_option("manoeuvre", request->manoeuvre,
                        "To be watched (`rsi-sil list` names all; default: you drive)");
    add_vehicle_options(*command, request->files);
    command->add_option("--output", request->output, "Folder for what a run leaves, of the latest drive")
        ->required();
    command->add_option("--speed", request->speed_kmh, "Speed of the first drive, in km/h (10 to 160)")
        ->check(number_within(10.0, 160.0))
        ->capture_default_str();
    command->add_option("--interface", request->interface,
                        "CAN interface of an ECU that runs, such as rsi-ecu (default: the firmware in this "
                        "process, with --parameters)");
    add_port_option(*command, request->port);
    add_whole_number(*command, "--seed", request->sensors.seed, "Seed of the sensor noise")
        ->default_str(fmt::format("{}", request->sensors.seed));
    command->add_flag("--noise,!--no-noise", request->sensors.noise,
                      "Sensors with noise, the default, or without: then sensors of a vehicle straight "
                      "ahead look stuck after a fault");
    command->callback([request] { watch(*request); });
}

}  // namespace sil
