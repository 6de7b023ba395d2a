// Population command: drawn vehicles, calibrated by identify alone, ready for campaigns.
#pragma once

#include <CLI/CLI.hpp>

namespace sil {

// Adds the subcommand `population` to `app`.
void add_population_command(CLI::App& app);

}  // namespace sil
