// Candump regression: recorded sensor frames through the firmware must give the recorded ECU frames, byte for
// byte.
//
// NAME.sensors.log holds the sensor frames, NAME.ecu.log what the firmware answered.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "sil/files/calibration_file.hpp"
#include "sil/files/candump_log.hpp"
#include "sil/files/sensor_frame.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/simulation/replay.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/application/regression/bus_faults.hpp"
#include "tests/application/regression/candump_compare.hpp"
#include "tests/application/regression/frame_description.hpp"

namespace {

struct Request {
    std::string base;        // path without ".sensors.log"
    std::string parameters;  // calibration of the firmware
    std::string manoeuvre;
    std::string vehicle;
    double duration_s{0.0};
    std::uint64_t seed{1U};
    bool mirrored{false};
    bool noise{false};
    bool bank_sensor{false};
    bool no_roll_sensor{false};
    bool no_steering_sensor{false};
    bool bus_faults{false};
};

std::string sensor_log(const Request& request) {
    return request.base + ".sensors.log";
}
std::string ecu_log(const Request& request) {
    return request.base + ".ecu.log";
}

void write_log(const std::string& path, const std::vector<sil::LoggedFrame>& frames) {
    sil::CandumpLogWriter writer{path};
    for (const sil::LoggedFrame& frame : frames) {
        writer.write(frame);
    }
    writer.close();
}

std::vector<sil::LoggedFrame> answers(const Request& request) {
    return sil::replay(sil::read_candump_log(sensor_log(request)), sil::load_calibration(request.parameters));
}

void check(const Request& request) {
    sil::CompareOptions options;
    options.describe = sil::describe_frame;
    const sil::LogComparison comparison =
        sil::compare_logs(sil::read_candump_log(ecu_log(request)), answers(request), options);
    fmt::print("{}\n", comparison.report);
    if (!comparison.equal) {
        throw std::runtime_error(
            fmt::format("the firmware no longer answers {} as {} says. If that is meant, run "
                        "tests/application/regression/renew "
                        "and commit the logs with the reason.",
                        sensor_log(request), ecu_log(request)));
    }
}

void renew(const Request& request) {
    write_log(ecu_log(request), answers(request));
}

sil::SensorOptions sensors(const sil::VehicleParameters& vehicle, const Request& request) {
    constexpr double not_available = std::numeric_limits<double>::quiet_NaN();
    sil::SensorFlaws flaws;
    flaws.noise = request.noise;
    flaws.seed = request.seed;
    flaws.bank_sensor = request.bank_sensor;
    sil::SensorOptions options = sil::mounted_sensors(vehicle, flaws);
    if (request.no_roll_sensor) {
        options.roll.roll_angle_rad.bias = not_available;
    }
    if (request.no_steering_sensor) {
        options.motion.steering_wheel_angle_rad.bias = not_available;
    }
    return options;
}

void drive(const Request& request, sil::CandumpLogWriter& log) {
    sil::RunOptions options;
    options.mirrored = request.mirrored;
    options.duration_s = request.duration_s;
    const sil::VehicleParameters vehicle = sil::load_vehicle(request.vehicle);
    sil::InProcessRun{vehicle,
                      sil::find_manoeuvre(request.manoeuvre),
                      options,
                      sensors(vehicle, request),
                      sil::load_calibration(request.parameters),
                      &log}
        .run();
}

// Keeps what the simulated sensors send; the answers come from a replay, as they will in every check.
void record(const Request& request) {
    sil::CandumpLogWriter whole{sensor_log(request)};
    drive(request, whole);
    whole.close();
    std::vector<sil::LoggedFrame> frames = sil::read_candump_log(sensor_log(request));
    frames.erase(
        std::remove_if(frames.begin(), frames.end(),
                       [](const sil::LoggedFrame& logged) { return !sil::is_sensor_frame(logged.frame); }),
        frames.end());
    write_log(sensor_log(request), request.bus_faults ? rsi_test::with_bus_faults(frames) : frames);
    renew(request);
}

CLI::App* add_use(CLI::App& app, const char* name, const char* what, Request& request) {
    CLI::App* use = app.add_subcommand(name, what);
    use->add_option("base", request.base, "Path of the logs, without .sensors.log")->required();
    use->add_option("--parameters", request.parameters, "Calibration of the firmware (TOML)")->required();
    return use;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Sensor frames in, ECU frames out, compared with what is committed", "candump_regression"};
    app.require_subcommand(1);
    Request request;
    add_use(app, "check", "Compare the firmware's answers with the committed ones", request)->callback([&] {
        check(request);
    });
    add_use(app, "renew", "Write the firmware's answers to the committed sensor frames", request)
        ->callback([&] { renew(request); });
    CLI::App* recorded =
        add_use(app, "record", "Drive a manoeuvre and write its sensor frames and answers", request);
    recorded->add_option("--manoeuvre", request.manoeuvre)->required();
    recorded->add_option("--vehicle", request.vehicle)->required();
    recorded->add_option("--duration", request.duration_s);
    recorded->add_option("--seed", request.seed);
    recorded->add_flag("--mirror", request.mirrored);
    recorded->add_flag("--noise", request.noise);
    recorded->add_flag("--bank-sensor", request.bank_sensor);
    recorded->add_flag("--no-roll-sensor", request.no_roll_sensor);
    recorded->add_flag("--no-steering-sensor", request.no_steering_sensor);
    recorded->add_flag("--bus-faults", request.bus_faults, "Plant the faults of bus_faults.hpp");
    recorded->callback([&] { record(request); });
    try {
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        fmt::print(stderr, "candump_regression: {}\n", error.what());
        return 1;
    }
}
