// Subcommand `fault-states`.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

void add_fault_states_command(CLI::App& app);

}  // namespace sil
