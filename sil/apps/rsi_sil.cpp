// rsi-sil: the world. Drives a simulated vehicle through a manoeuvre and talks to the ECU over a CAN
// interface.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "sil/apps/command_line.hpp"
#include "sil/apps/commands.hpp"
#include "sil/apps/identify_command.hpp"
#include "sil/apps/replay_command.hpp"
#include "sil/apps/run_command.hpp"
#include "sil/simulation/bus_timing.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"

namespace {

void list_manoeuvres() {
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        fmt::print("{:<24} {}\n", manoeuvre.name, manoeuvre.description);
    }
}

void print_timing(const std::filesystem::path& log) {
    try {
        fmt::print("{}", sil::describe(sil::bus_timing(sil::read_candump_log(log))));
    } catch (const sil::NoTiming& error) {
        throw std::runtime_error(fmt::format("{}: {}", log.string(), error.what()));
    }
}

void add_pace(CLI::App& run, sil::RunRequest& request) {
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

void add_run(CLI::App& app, sil::RunRequest& request) {
    CLI::App* run =
        app.add_subcommand("run", "Drive a manoeuvre against an ECU, on a CAN interface or in this process");
    run->add_option("manoeuvre", request.manoeuvre, "Its name; `rsi-sil list` names all")->required();
    run->add_option("--vehicle", request.vehicle_file, "Parameter file of the simulated vehicle (TOML)")
        ->required();
    run->add_option("--output", request.output, "Folder for the results")->required();
    sil::add_whole_number(*run, "--seed", request.sensors.seed, "Seed of the sensor noise")
        ->default_str(fmt::format("{}", request.sensors.seed));
    run->add_option("--duration", request.duration_s, "Seconds of simulated time (default: the manoeuvre's)")
        ->check(sil::number_within(0.01, 1.0e6));
    run->add_option("--bias", request.sensors.bias_g, "Bias of the accelerometers, in g (-1 to 1)")
        ->check(sil::number_within(-1.0, 1.0));
    run->add_option("--quantisation", request.sensors.quantisation_g,
                    "Least step of the accelerometers, in g (0 to 1)")
        ->check(sil::number_within(0.0, 1.0));
    run->add_flag("--bank-sensor", request.sensors.bank_sensor, "The vehicle measures the road's bank, too");
    run->add_flag("--attitude-sensor", request.sensors.attitude_sensor,
                  "The vehicle measures the roll angle against the horizon, not against the road");
    run->add_flag("--mass-sensor", request.sensors.mass_sensor,
                  "The vehicle measures its mass by the axle loads, as trucks do");
    run->add_flag("--noise", request.sensors.noise, "Sensors with noise");
    run->add_flag("--mirror", request.mirrored, "Left and right exchanged");
    add_pace(*run, request);
    run->callback([&request] { sil::run_manoeuvre(request); });
}

void add_timing(CLI::App& app, std::filesystem::path& log) {
    CLI::App* timing =
        app.add_subcommand("timing", "Cycle jitter and reaction time of the ECU from a candump log");
    timing->add_option("log", log, "Log written by `candump -L`")->required();
    timing->callback([&log] { print_timing(log); });
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"The simulated world of the rollover-warning ECU", "rsi-sil"};
    app.require_subcommand(1);
    sil::RunRequest request;
    std::filesystem::path log;
    sil::ReplayRequest replay;
    app.add_subcommand("list", "Name all manoeuvres")->callback(list_manoeuvres);
    add_run(app, request);
    sil::add_watch_command(app);
    sil::add_show_command(app);
    add_timing(app, log);
    sil::add_replay_command(app, replay);
    sil::add_campaign(app);
    sil::add_population_command(app);
    sil::add_procedure_command(app);
    sil::add_faults_command(app);
    sil::add_fault_states_command(app);
    sil::add_fault_search_command(app);
    sil::add_memory_flips_command(app);
    sil::add_identify_command(app);
    sil::add_validate_command(app);
    sil::add_parameters_command(app);
    return sil::run_program(app, [&] {
        try {
            app.parse(argc, argv);
        } catch (const sil::UnknownManoeuvre& error) {
            throw sil::UsageError{error.what()};
        }
    });
}
