// Commands: the subcommands of rsi-sil, each in a source of its own. Their callbacks throw std::exception
// with a message for the user.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

void add_campaign(CLI::App& app);
void add_fault_search_command(CLI::App& app);
void add_fault_states_command(CLI::App& app);
void add_faults_command(CLI::App& app);  // and `endurance`, `intermittent-faults`
void add_memory_flips_command(CLI::App& app);
void add_parameters_command(CLI::App& app);
void add_population_command(CLI::App& app);
void add_procedure_command(CLI::App& app);
void add_run_command(CLI::App& app);
void add_show_command(CLI::App& app);
void add_validate_command(CLI::App& app);
// Serves the page of a drive until it is ended, and leaves what a run leaves of the last drive.
void add_watch_command(CLI::App& app);

}  // namespace sil
