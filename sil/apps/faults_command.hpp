// Faults command: the fault matrix, as a page or compared with one.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// Adds the subcommand `faults` to `app`.
void add_faults_command(CLI::App& app);

}  // namespace sil
