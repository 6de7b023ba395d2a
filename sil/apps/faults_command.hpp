// Faults commands: the fault matrix, as a page or compared with one; hours of driving with random faults.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// Adds the subcommands `faults` and `endurance` to `app`.
void add_faults_command(CLI::App& app);

}  // namespace sil
