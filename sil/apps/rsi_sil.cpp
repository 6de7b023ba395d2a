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
    std::filesystem::path log;
    sil::ReplayRequest replay;
    app.add_subcommand("list", "Name all manoeuvres")->callback(list_manoeuvres);
    sil::add_run_command(app);
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
