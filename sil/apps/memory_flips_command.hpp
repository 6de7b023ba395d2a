// Memory flips command: single bits of the ECU's memory that change, and what becomes of the warning.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// Adds the subcommand `memory-flips` to `app`.
void add_memory_flips_command(CLI::App& app);

}  // namespace sil
